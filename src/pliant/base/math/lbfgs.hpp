// SPDX-License-Identifier: MIT
// L-BFGS: minimises a smooth function of many points (J. Nocedal, Math. Comput. 35 (1980) 773).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// The value at `x` (n). Writes the gradient to `gradient` (n).
using ValueAndGradient = std::function<double(std::span<const Vec3> x, std::span<Vec3> gradient)>;

struct MinimiseOptions {
  std::size_t steps = 120;   ///< at most
  std::size_t memory = 10;   ///< steps that the curvature is known from
  double tolerance = 1e-4;   ///< of the largest component of the gradient
  double least_gain = 1e-9;  ///< of the value: a step that gains less ends it
};

struct Minimum {
  double value = 0.0;
  std::size_t evaluations = 0;
  bool has_converged = false;  ///< else it ran out of steps
};

/// Goes downhill from `x`, which is left at the lowest point found. The same input gives the same
/// bits.
Minimum minimise(const ValueAndGradient& function, std::vector<Vec3>& x,
                 const MinimiseOptions& options = {});

}  // namespace pliant
