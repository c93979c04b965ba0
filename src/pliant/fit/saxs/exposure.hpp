// SPDX-License-Identifier: MIT
// How much of each group of atoms the solvent touches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/fit/saxs/form_factors.hpp"

namespace pliant {

/// Points on the sphere around a group.
inline constexpr std::uint32_t exposure_points = 64;

/// How many of the points around each group, at its radius and that of a water (1.8 Angstrom), are
/// inside of no other such sphere: A. Shrake, J. Rupley, J. Mol. Biol. 79 (1973) 351. Linear in the
/// number of groups.
std::vector<std::uint32_t> exposures(std::span<const ScatteringGroup> groups,
                                     std::span<const Vec3> positions);

}  // namespace pliant
