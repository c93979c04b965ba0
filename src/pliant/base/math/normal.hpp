// SPDX-License-Identifier: MIT
// Normally distributed (Gaussian) random numbers, the same bits on every machine.
#pragma once

#include <span>

#include "pliant/base/random.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// Fills `out` with independent normal numbers of mean 0 and variance 1, two at a time from points
/// in the unit circle (polar method: Marsaglia, Bray, SIAM Rev. 6 (1964) 260).
void fill_normal(RandomSequence& draws, std::span<double> out);

/// Three of them.
Vec3 normal_vector(RandomSequence& draws);

}  // namespace pliant
