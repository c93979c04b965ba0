// SPDX-License-Identifier: MIT
// The forms that a system of small rings which share bonds can take.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"
#include "pliant/sample/rings/ring_forms.hpp"
#include "pliant/sample/rings/ring_systems.hpp"

namespace pliant {

/// Forms of a system with all bars of the framework between its atoms but those across
/// `system_angles`, which may be off by 0.12 Angstrom, and with the handedness of each atom at
/// which three bonds of the system meet. The first is that of `start`. What Gauss-Newton steps
/// reach from 300 starts, always the same ones: the system as it is or pressed flat, atoms shifted
/// at random. Two forms differ by 0.37 Angstrom (root of the sum of squares).
std::vector<RingForm> system_forms(const RingSystem& system, const Framework& framework,
                                   const BondChemistry& chemistry, std::span<const Vec3> start);

}  // namespace pliant
