// SPDX-License-Identifier: MIT
// Rotations spread evenly over all there are.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/base/math/best_fit.hpp"

namespace pliant {

/// `count` rotations spread evenly, the same ones each time: along a spiral on the sphere of
/// quaternions (M. Alexa, CVPR 2022, 8291). Neighbours are some 400 degrees / cube root of count
/// apart.
std::vector<Rotation> spread_rotations(std::size_t count);

}  // namespace pliant
