// SPDX-License-Identifier: MIT
// The forms of a system of small rings that share bonds.
#pragma once

#include <span>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/rings/ring_forms.hpp"
#include "pliant/conformers/rings/ring_systems.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Forms of a system that satisfy all bars between its atoms, except those across `system_angles`,
/// which may deviate by 0.12 Angstrom, and that keep the handedness of each atom with three bonds
/// of the system. That of `start` is the first. The others result from Gauss-Newton steps from 300
/// fixed starts at most: the system as it is or flattened, with atoms shifted at random. Fewer are
/// tried where the last 24, and 3 more for each known form, gave no new one, or where there are
/// `most` forms. Two forms differ by 0.37 Angstrom (root of the sum of squares).
std::vector<RingForm> system_forms(const RingSystem& system, const Framework& framework,
                                   const BondChemistry& chemistry, std::span<const Vec3> start,
                                   std::size_t most = 60);

}  // namespace pliant
