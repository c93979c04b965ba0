// SPDX-License-Identifier: MIT
// Rings that pucker, and the distances that hold their angles.
#pragma once

#include <span>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"

namespace pliant {

/// Number of atoms; larger rings change by their torsions (loop_draws.hpp).
constexpr std::size_t largest_small_ring = 6;

/// Rings that share no bond with another and are not planar (0.1 Angstrom) at `start` (N).
std::vector<SimpleRing> puckered_rings(const BondChemistry& chemistry, std::span<const Vec3> start);

/// Sorts pairs by a, then b, and removes repetitions.
void sort_pairs(std::vector<Bar>& pairs);

/// For a ring of five or six: pairs, a < b, sorted, across the angles at its atoms with a bond of
/// the ring as a side, which change when the ring takes another form. Empty for other rings.
std::vector<Bar> ring_angles(const SimpleRing& ring, const BondChemistry& chemistry);

}  // namespace pliant
