// SPDX-License-Identifier: MIT
// Elements by the names of atoms and of their residues, where a file says nothing else.
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// Amino acids, nucleotides, caps and water under their usual names: their atoms are of the
/// elements H, C, N, O, P, S only (and Se in MSE).
bool is_standard_residue(std::string_view name);

/// Names of four letters that begin like a standard residue: "TIP3", "NALA".
bool is_long_residue_name(std::string_view name);

/// The element that an atom name (columns 13-16, with its blanks) stands for: " CA " is carbon,
/// "CA  " calcium unless the residue is standard; 0 where it tells none.
std::uint8_t element_of_pdb_name(std::string_view padded_name, std::string_view residue_name);

/// The same for a name without its blanks, as mmCIF has it.
std::uint8_t element_of_bare_name(std::string_view name, std::string_view residue_name);

}  // namespace pliant
