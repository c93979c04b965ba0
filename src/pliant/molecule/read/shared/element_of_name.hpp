// SPDX-License-Identifier: MIT
// Elements from the names of atoms and their residues, where a file does not state them.
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// Whether the name is a usual one of amino acids, nucleotides, caps or water, whose atoms have
/// only the elements H, C, N, O, P, S (and Se in MSE).
bool is_standard_residue(std::string_view name);

/// Whether a name of four letters begins like a standard residue: "TIP3", "NALA".
bool is_long_residue_name(std::string_view name);

/// The element of an atom name (columns 13-16, with its blanks): " CA " is carbon, "CA  " calcium
/// unless the residue is standard; 0 if the name gives none.
std::uint8_t element_of_pdb_name(std::string_view padded_name, std::string_view residue_name);

/// The same for a name without blanks, as in mmCIF.
std::uint8_t element_of_bare_name(std::string_view name, std::string_view residue_name);

}  // namespace pliant
