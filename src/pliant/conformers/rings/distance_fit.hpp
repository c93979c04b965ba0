// SPDX-License-Identifier: MIT
// Moves a few points as little as possible to given distances.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

struct WantedDistance {
  std::size_t i, j;
  double square;  ///< Angstrom^2
};

/// Makes the Gauss-Newton step of least change. Returns the largest relative error of a squared
/// distance before the step. `damped`, in units of the largest diagonal entry, lets distances
/// deviate; the larger, the more.
double approach(const std::vector<WantedDistance>& wanted, double damped, std::vector<Vec3>& x);

/// Repeats approach() until all distances are exact to rounding. Returns false if that fails.
bool meet(const std::vector<WantedDistance>& wanted, std::vector<Vec3>& x);

}  // namespace pliant
