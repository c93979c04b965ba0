// SPDX-License-Identifier: MIT
// Equations of a step of Gauss and Newton over the turns d of hinges: each row adds
// weight (off + row . d)^2 to the sum that is least.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/sample/conformers/loop_plan.hpp"

namespace pliant {

class LoopEquations {
 public:
  /// The hinges outlive it.
  explicit LoopEquations(std::span<const LoopHinge> hinges)
      : hinges_(hinges), axes_(hinges.size()) {}

  /// No rows; `x` (places, Angstrom) outlives the equations. `damping` times d^2 is in the sum.
  void begin(std::span<const Vec3> x, double damping);
  /// Begins a row.
  void begin_row() { row_.assign(hinges_.size(), 0.0); }
  /// The row's gradient by a place.
  void add_to_row(Slot place, Vec3 gradient);
  void end_row(double off, double weight);
  /// Damping by a share of the mean of the diagonal more.
  void add_damping(double share);
  /// The turns of hinges (radians); empty if there is no solution.
  std::span<const double> solve();

 private:
  std::span<const LoopHinge> hinges_;
  std::span<const Vec3> x_;
  std::vector<Vec3> axes_;  ///< of length 1
  std::vector<double> matrix_, right_, row_;
};

}  // namespace pliant
