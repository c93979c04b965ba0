// SPDX-License-Identifier: MIT
// Elements of PDB atoms: from columns 77-78, otherwise from the padded atom name and the residue
// (element_of_name.hpp).
#pragma once

#include <cstdint>
#include <string_view>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Finds the elements of a file's atoms, one after another.
class PdbElements {
 public:
  /// The element of an ATOM or HETATM record in residue `residue_name`. Warns once of blank
  /// columns, of columns without an element, and of names that give none.
  std::uint8_t next(const PdbLine& line, std::string_view residue_name, Remarks& remarks);

 private:
  std::uint8_t guess(std::string_view name, std::string_view residue_name);

  bool left_justified_ = false;  // names begin in column 13, so that padding gives no element
};

}  // namespace pliant
