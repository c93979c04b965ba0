// SPDX-License-Identifier: MIT
// Bends flexible loops of bodies at random, where they cannot be drawn (loop_draws.hpp).
#pragma once

#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// For each body whether it is on a flexible loop: on the tree path from an end of a cut to where
/// the paths of both ends meet.
std::vector<bool> bodies_in_loops(const BodyPlan& plan);

class LoopBending {
 public:
  /// The plan must outlive it.
  LoopBending(const BodyPlan& plan, std::vector<bool> is_in_loop)
      : plan_(plan), is_in_loop_(std::move(is_in_loop)) {}

  /// Displaces the targets of flexible loops, and of what hangs on them, by a random smooth
  /// bending. Bars are not kept.
  void push(RandomSequence& draws, std::span<Vec3> targets) const;

 private:
  Vec3 middle_of(const PlanBody& body, std::span<const Vec3> x) const;

  const BodyPlan& plan_;
  std::vector<bool> is_in_loop_;  ///< (bodies)
};

}  // namespace pliant
