// SPDX-License-Identifier: MIT
// Moves a few points by the least until distances between them are as wanted.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

struct WantedDistance {
  std::size_t i, j;
  double square;  ///< Angstrom^2
};

/// A step of Gauss-Newton of least change; the worst share by which a squared distance was off
/// before. `damped`, of the largest diagonal entry: distances need not be met, the less the larger.
double approach(const std::vector<WantedDistance>& wanted, double damped, std::vector<Vec3>& x);

/// Until all distances are met to rounding; false if that fails.
bool meet(const std::vector<WantedDistance>& wanted, std::vector<Vec3>& x);

}  // namespace pliant
