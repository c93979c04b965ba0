// SPDX-License-Identifier: MIT
// Resolves a framework with limits and sterics from any push, in torsion space: rigid units stay
// exact at every step while they are pulled towards where the joints were pushed, and are then
// pushed until every limit and every least distance holds. How and why: ../README.md, froda.
#pragma once

#include <span>

#include "pliant/resolve/froda/froda_frame.hpp"

namespace pliant {

/// Not for two threads at once.
class FrodaSolver {
 public:
  /// Both outlive it. `unit` (Angstrom): of the lengths by which steps are bounded and damped, 1
  /// for molecules.
  FrodaSolver(const Framework& framework, const BodyPlan& plan, double unit = 1.0);

  /// `start` (N, Angstrom): all bars are whole. `target` (N): where the push wants the joints.
  /// Writes `out` (N; may be either): bars as whole as at the start, to rounding. A function of its
  /// arguments alone.
  FrodaOutcome resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                       std::span<Vec3> out, const FrodaOptions& options = {},
                       LimitsOff limits_off = {});

 private:
  FrodaOutcome finish(std::span<Vec3> out);
  void pull();
  bool pull_blindly();
  double step();

  FrodaFrame frame_;
  ArticulatedStep step_;
  double unit_;
};

}  // namespace pliant
