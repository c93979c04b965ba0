// SPDX-License-Identifier: MIT
// Elements of PDB atoms: from columns 77-78, otherwise from the padded atom name and the residue
// (element_of_name.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Whether an ATOM or HETATM record is one of PDBQT (AutoDock, Vina): a partial charge in columns
/// 71-76 and an AutoDock type in columns 78-79, where PDB files have a segment and an element.
bool is_pdbqt_atom(std::string_view line);

/// The element of an AutoDock type ("A" is aromatic carbon, "OA" oxygen); 0 for sites that are no
/// atoms ("W", "Z", "G0"); nothing for what is no type.
std::optional<std::uint8_t> element_of_autodock_type(std::string_view type);

/// Finds the elements of a file's atoms, one after another.
class PdbElements {
 public:
  explicit PdbElements(bool is_pdbqt) : is_pdbqt_(is_pdbqt) {}

  /// The element of an ATOM or HETATM record in residue `residue_name`. Warns once of blank
  /// columns, of columns without an element, and of names that give none.
  std::uint8_t next(const PdbLine& line, std::string_view residue_name, Remarks& remarks);

 private:
  std::uint8_t guess(std::string_view name, std::string_view residue_name);

  bool is_pdbqt_;
  bool left_justified_ = false;  // names begin in column 13, so that padding gives no element
};

}  // namespace pliant
