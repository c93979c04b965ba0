// SPDX-License-Identifier: MIT
// A molecule read from an SDF record; shared by the readers of V2000 and V3000.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/shared/remarks.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {

/// Collects atoms and bonds of one record.
class MolBlock {
 public:
  explicit MolBlock(Remarks& remarks) : remarks_(remarks) {}

  /// Adds an atom. A `symbol` that is not exactly an element ("*", "R#", "A") gives a warning and
  /// no element.
  void add_atom(std::string_view symbol, Vec3 position, std::int64_t serial, std::size_t line);
  void set_charge(std::size_t atom, std::int64_t charge, std::size_t line);
  /// Sets a mass number, such as 13 for carbon-13; 0: the natural mixture.
  void set_isotope(std::size_t atom, std::int64_t mass, std::size_t line);
  /// Sets 1 singlet, 2 doublet, 3 triplet; 0: none.
  void set_radical(std::size_t atom, std::int64_t multiplicity, std::size_t line);
  /// Charges and radicals of the property block replace those of atom lines.
  void clear_charges_and_radicals();
  void clear_isotopes() { structure_.isotopes.clear(); }
  std::uint8_t element(std::size_t atom) const { return structure_.atoms.elements[atom]; }

  /// Adds a bond between atoms by index, with the format's type: 1, 2, 3, 4 aromatic; 0 and 5 to 9
  /// have an unknown order; 10 (a hydrogen bond) is left out with a warning. Refuses other types.
  void add_bond(std::size_t a, std::size_t b, std::int64_t type, std::size_t line);

  Remarks& remarks() const { return remarks_; }
  std::size_t size() const { return structure_.size(); }
  std::size_t bond_count() const { return bonds_.size() + left_out_; }

  /// Returns the structure: bonds sorted, repeated ones merged with a warning; warns of flat
  /// structures.
  Structure take();

 private:
  struct LineBond {
    Bond bond;
    std::size_t line;
  };

  Remarks& remarks_;
  Structure structure_;
  std::vector<LineBond> bonds_;
  std::size_t left_out_ = 0;
};

/// Moves to the next line of a record. Throws InputError where the record or the file ends;
/// `wanted` says what should follow: "atom 3 of 5".
std::string_view next_record_line(Lines& lines, std::string_view wanted, const Remarks& remarks);

/// Whether a line ends a record of an SDF.
bool ends_record(std::string_view line);

}  // namespace pliant
