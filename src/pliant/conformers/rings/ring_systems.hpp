// SPDX-License-Identifier: MIT
// Systems of rings of at most six atoms that share bonds (fused, bridged: decalin, steroids,
// norbornane), and of seven, if a bond between flat atoms holds them (benzazepine).
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"

namespace pliant {

struct RingSystem {
  std::vector<Joint> atoms;                          ///< ascending
  std::vector<std::vector<std::size_t>> neighbours;  ///< for each atom, indices into `atoms`
  std::vector<std::vector<std::size_t>> rings;       ///< of at most seven atoms each, in order
};

/// Systems that consist only of such rings, have at most 64 bonds, and have an atom that is neither
/// aromatic nor planar.
std::vector<RingSystem> ring_systems(const BondChemistry& chemistry);

/// Pairs, a < b, sorted, across the angles at tetrahedral atoms with a bond of the system as a
/// side, which change when the system takes another form.
std::vector<Bar> system_angles(const RingSystem& system, const BondChemistry& chemistry);

}  // namespace pliant
