// SPDX-License-Identifier: MIT
// Resolves a framework with limits and sterics after any push, in torsion space: rigid units remain
// exact at every step while they are pulled towards the pushed joints, and are then pushed until
// every limit and every least distance holds. See ../README.md, froda.
#pragma once

#include <memory>
#include <span>

#include "pliant/resolve/bodies/pull/froda_frame.hpp"

namespace pliant {

/// Not thread-safe.
class FrodaSolver {
 public:
  /// Both must outlive it. `unit` (Angstrom) is the unit of lengths that bound and damp steps, 1
  /// for molecules.
  FrodaSolver(const Framework& framework, const BodyPlan& plan, double unit = 1.0);

  /// `start` (N, Angstrom): whole positions. `target` (N): where the push wants the joints. Writes
  /// `out` (N; may be either): bars as whole as at the start, to rounding. Depends on the arguments
  /// alone.
  FrodaResult resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                      std::span<Vec3> out, const FrodaOptions& options = {},
                      LimitsOff limits_off = {});
  FrodaResult resolve(const FrodaPush& push, std::span<Vec3> out, const FrodaOptions& options);

 private:
  FrodaResult finish(std::span<Vec3> out);
  void pull();
  bool pull_blindly();
  double step();

  FrodaFrame frame_;
  ArticulatedStep step_;
  double unit_;
};

/// A solver with a plan of its own, for a framework of any size: half the mean length of its bars
/// is the unit of lengths.
struct PlannedFroda {
  PlannedFroda(const Framework& framework, BodyPlan bodies);

  BodyPlan plan;
  FrodaSolver solver;
};

/// The framework must outlive it. Null where BodyPlan::make() gives none, or one with more than 200
/// cuts, each of which takes equations that are solved densely.
std::unique_ptr<PlannedFroda> plan_froda(const Framework& framework);

}  // namespace pliant
