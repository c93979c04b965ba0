// SPDX-License-Identifier: MIT
// A term of the energy of a fit: data, or what keeps the shape.
#pragma once

#include <cstddef>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Data count little at first and much at last, so that shapes follow before details do.
inline constexpr double fit_weights[] = {0.2, 1.0, 5.0, 20.0};

class FitTerm {
 public:
  virtual ~FitTerm() = default;

  /// Called with the nodes as they are before each minimisation; `stage` is an index into
  /// fit_weights.
  virtual void begin(std::size_t /*stage*/, std::span<const Vec3> /*nodes*/) {}

  /// Returns the value at nodes (M), and adds its gradient to `gradient` (M).
  virtual double add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const = 0;
};

}  // namespace pliant
