// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_element.hpp"

#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/element_of_name.hpp"

namespace pliant {

/// Padding puts a heavy atom of a standard residue into column 14: one in column 13 shows that the
/// program that wrote the file does not pad.
std::uint8_t PdbElements::guess(std::string_view name, std::string_view residue_name) {
  if (left_justified_) return element_of_bare_name(name, residue_name);
  const std::uint8_t element = element_of_pdb_name(name, residue_name);
  const std::string_view letters = element_symbol(element);
  const bool heavy = letters == "C" || letters == "N" || letters == "O" || letters == "S";
  left_justified_ = heavy && name.size() == 4 && name[0] == letters[0] && name[3] == ' ' &&
                    is_standard_residue(residue_name);
  return element;
}

std::uint8_t PdbElements::next(const PdbLine& line, std::string_view residue_name,
                               Remarks& remarks) {
  const std::string_view field = trimmed(columns(line.text, 77, 78));
  const std::string_view name = columns(line.text, 13, 16);
  if (const std::uint8_t element = element_number(field)) return element;
  const bool letters = !field.empty() && !is_digit(field[0]) && !is_digit(field.back());
  if (letters) {
    remarks.warn("unknown element", line.number, [&] {
      return "element (columns 77-78) " + quoted(field) + " is not known: taken as unknown";
    });
    return 0;
  }
  const std::uint8_t element = guess(name, residue_name);
  if (element != 0) {
    remarks.warn("element from name", line.number, [&] {
      return "no element in columns 77-78: taken from the atom name, " + quoted(name) + " as " +
             std::string(element_symbol(element));
    });
  } else {
    remarks.warn("no element", line.number, [&] {
      return "atom " + quoted(trimmed(name)) + " of residue " + quoted(residue_name) +
             " has no element: a dummy site, or unknown";
    });
  }
  return element;
}

}  // namespace pliant
