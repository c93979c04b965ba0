// SPDX-License-Identifier: MIT
// The place around selected atoms: residues that a frame opens or closes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

inline constexpr double place_distance = 6.0;  ///< Angstrom, between atoms other than hydrogen

struct Pocket {
  std::vector<std::uint32_t> residues;  ///< of the atom table, ascending
  std::vector<bool> has_joint;          ///< (N)
  std::vector<Joint> ligand;            ///< if no protein is selected: all of the residues that are
};

/// The residues of proteins among the selected atoms; if there are none (a ligand), those with an
/// atom near to one that is selected. No atoms: everything. `start` (N, Angstrom). Throws
/// OptionError if no residue is near.
Pocket pocket_around(const Framework& framework, std::span<const Vec3> start,
                     std::span<const Joint> selected);

/// The names of its residues: "A:LYS12".
std::vector<std::string> names_of(const Pocket& place, const Framework& framework);

}  // namespace pliant
