// SPDX-License-Identifier: MIT
// Equations of a Gauss-Newton step over the turns d of hinges. Each row adds weight (off + row .
// d)^2 to the sum that is minimized.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/conformers/torsions/loop_plan.hpp"

namespace pliant {

class LoopEquations {
 public:
  /// The hinges must outlive it.
  explicit LoopEquations(std::span<const LoopHinge> hinges)
      : hinges_(hinges), axes_(hinges.size()) {}

  /// Removes all rows; `x` (places, Angstrom) must outlive the equations. `damping` d^2 is added to
  /// the sum.
  void begin(std::span<const Vec3> x, double damping);
  /// Begins a row.
  void begin_row() { row_.assign(hinges_.size(), 0.0); }
  /// Adds the row's gradient with respect to a place.
  void add_to_row(Slot place, Vec3 gradient);
  void end_row(double off, double weight);
  /// Adds to the damping a share of the mean of the diagonal.
  void add_damping(double share);
  /// Returns the turns of the hinges (radians); empty if there is no solution.
  std::span<const double> solve();

 private:
  std::span<const LoopHinge> hinges_;
  std::span<const Vec3> x_;
  std::vector<Vec3> axes_;  ///< (hinges) unit vectors
  std::vector<double> matrix_, right_, row_;
};

}  // namespace pliant
