// SPDX-License-Identifier: MIT
// Directions spread evenly over the sphere.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// `count` unit vectors, the same ones each time: a spiral by the golden angle.
std::vector<Vec3> spread_directions(std::size_t count);

}  // namespace pliant
