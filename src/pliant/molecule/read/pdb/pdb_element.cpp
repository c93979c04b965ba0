// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_element.hpp"

#include <array>
#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/element_of_name.hpp"

namespace pliant {
namespace {

/// Types whose element is not what their letters say (AutoDock 4.2, Vina, Meeko).
struct AutodockType {
  std::string_view type, symbol;
};
constexpr auto autodock_types = std::to_array<AutodockType>({
    {"A", "C"},  // aromatic carbon
    {"G", "C"},  // carbons that close a ring
    {"GA", "C"},
    {"J", "C"},
    {"Q", "C"},
    {"CG", "C"},
    {"HD", "H"},  // donors
    {"HS", "H"},
    {"NA", "N"},  // acceptors; sodium is Na
    {"NS", "N"},
    {"OA", "O"},
    {"OS", "O"},
    {"SA", "S"},
    {"W", ""},  // sites that are no atoms: hydration, covalent maps
    {"Z", ""},
});

std::string_view without_last_digit(std::string_view type) {
  if (type.size() > 1 && is_digit(type.back())) type.remove_suffix(1);
  return type;
}

}  // namespace

std::optional<std::uint8_t> element_of_autodock_type(std::string_view type) {
  if (type.size() == 2 && type[0] == 'G' && is_digit(type[1])) return std::uint8_t{0};
  type = without_last_digit(type);  // CG0 and CG1 close different rings
  for (const AutodockType& row : autodock_types)
    if (row.type == type) return element_number(row.symbol);
  const std::uint8_t element = element_number(type);
  return element != 0 ? std::optional(element) : std::nullopt;
}

bool is_pdbqt_atom(std::string_view line) {
  const std::string_view charge = trimmed(columns(line, 67, 76));
  return column(line, 73) == '.' && parse_real(charge).has_value() && column(line, 77) == ' ' &&
         element_of_autodock_type(trimmed(columns(line, 78, 80))).has_value();
}

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
  if (is_pdbqt_) {
    if (const auto known = element_of_autodock_type(trimmed(columns(line.text, 78, 80))))
      return *known;
  }
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
