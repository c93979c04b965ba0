// SPDX-License-Identifier: MIT
// Elements of PDB atoms: from columns 77-78, else from the padded atom name and the residue.
#pragma once

#include <cstdint>
#include <string_view>

#include "pliant/molecule/read/pdb_columns.hpp"

namespace pliant {

/// Amino acids, nucleotides, caps and water under their usual names: their atoms are of the
/// elements H, C, N, O, P, S only (and Se in MSE).
bool is_standard_residue(std::string_view name);

/// Names of four letters that begin like a standard residue: "TIP3", "NALA".
bool is_long_residue_name(std::string_view name);

/// Finds the elements of a file's atoms, one after the other.
class PdbElements {
 public:
  /// The element of an ATOM or HETATM record in residue `residue_name`. Warns once of each: columns
  /// that are blank, no element, or a name that tells none.
  std::uint8_t next(const PdbLine& line, std::string_view residue_name, Remarks& remarks);

 private:
  std::uint8_t guess(std::string_view name, std::string_view residue_name);

  bool left_justified_ = false;  // names begin in column 13: padding tells no element
};

/// The element that an atom name (columns 13-16, with its blanks) stands for: " CA " is carbon,
/// "CA  " calcium unless the residue is standard; 0 where it tells none.
std::uint8_t element_of_pdb_name(std::string_view padded_name, std::string_view residue_name);

/// The same for a name without its blanks, as mmCIF has it.
std::uint8_t element_of_bare_name(std::string_view name, std::string_view residue_name);

}  // namespace pliant
