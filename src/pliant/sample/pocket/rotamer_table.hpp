// SPDX-License-Identifier: MIT
// Rotamers: torsions that side chains of proteins have, and how often, counted by
// data/count_rotamers.py over 4100 residues of 17 files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace pliant {

/// The atoms along a side chain, each four of which make a torsion; "" behind the last.
struct SideChainAtoms {
  std::string_view residue;
  std::array<std::string_view, 8> atoms;
};

inline constexpr std::int16_t no_torsion = -1;

/// States of one torsion or of two that follow each other.
struct Rotamer {
  std::string_view residue;
  std::uint8_t first;                    ///< the first torsion, from 0
  std::array<std::int16_t, 2> torsions;  ///< multiples of 30 degrees; second: maybe no_torsion
  std::uint8_t percent;                  ///< of the residues counted
};

/// Half of the width of a state (degrees).
inline constexpr double rotamer_spread = 15.0;

/// HIS for the names that force fields give it; others as they are.
std::string_view amino_acid_of(std::string_view residue);

/// N, CA, CB and so on; none for residues without torsions.
std::span<const std::string_view> atoms_along_side_chain(std::string_view residue);

/// The states of torsion `first` (0 with 1, 2, 3); none if there are none.
std::span<const Rotamer> rotamers_of(std::string_view residue, std::size_t first);

}  // namespace pliant
