// SPDX-License-Identifier: MIT
// Rings of at most six atoms that share bonds (fused, bridged: decalin, steroids, norbornane).
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

struct RingSystem {
  std::vector<Joint> atoms;                          ///< ascending
  std::vector<std::vector<std::size_t>> neighbours;  ///< of each atom, places in `atoms`
  std::vector<std::vector<std::size_t>> rings;       ///< of at most six atoms each, in order
};

/// Systems that are made of such rings alone, and have an atom that is neither aromatic nor planar;
/// of at most 64 bonds.
std::vector<RingSystem> ring_systems(const BondChemistry& chemistry);

/// Pairs, a < b, across those angles at tetrahedral atoms of the system that have a bond of it for
/// a side, sorted: they give way when it takes another form.
std::vector<Bar> system_angles(const RingSystem& system, const BondChemistry& chemistry);

}  // namespace pliant
