// SPDX-License-Identifier: MIT
// Rings that pucker: which they are, and the distances that hold their angles.
#pragma once

#include <span>
#include <vector>

#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

/// Atoms: larger rings change by their torsions (loop_draws.hpp).
constexpr std::size_t largest_small_ring = 6;

/// Rings that share no bond with another and do not lie in a plane (0.1 Angstrom) at `start` (N).
std::vector<SimpleRing> puckered_rings(const BondChemistry& chemistry, std::span<const Vec3> start);

/// Sorts pairs by a, then b, and leaves each once.
void sort_pairs(std::vector<Bar>& pairs);

/// Of a ring of five or six the pairs, a < b, across those angles at its atoms that have a bond of
/// the ring for a side, sorted; they give way when the ring takes another form. Else none.
std::vector<Bar> ring_angles(const SimpleRing& ring, const BondChemistry& chemistry);

}  // namespace pliant
