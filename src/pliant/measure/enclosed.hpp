// SPDX-License-Identifier: MIT
// Which places have atoms around them.
#pragma once

#include <cstddef>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// How many of the `points` are enclosed by atoms at `positions` (n) of `radii` (n), Angstrom: at
/// least half of 30 directions meet an atom within 8 Angstrom. 0 of none.
std::size_t count_enclosed(std::span<const Vec3> points, std::span<const Vec3> positions,
                           std::span<const double> radii);

}  // namespace pliant
