// SPDX-License-Identifier: MIT
// The step of an ArticulatedStep for eight frames at once, in SIMD lanes, to the same bits.
// Contacts, which differ between frames, are added one by one.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/tree/articulated_step.hpp"
#include "pliant/resolve/lanes/lane_bodies.hpp"

namespace pliant {

/// A frame that takes a step: its positions (places) and the request of the step.
struct LaneStepFrame {
  Vec3* x = nullptr;  ///< null: the lane is empty
  const StepRequest* request = nullptr;
};

class LaneStep {
 public:
  /// The plan must outlive it, and has bodies but no cut loops. All bodies take part. `kernels` are
  /// those of a level.
  LaneStep(const BodyPlan& plan, const LaneKernels& kernels);
  LaneStep(const LaneStep&) = delete;  // points to its own members
  LaneStep& operator=(const LaneStep&) = delete;

  /// Makes one step of each frame, with the same number of conjugate gradients; at least one frame.
  void step(std::span<const LaneStepFrame, lane_count> frames);

 private:
  void load(std::span<const LaneStepFrame, lane_count> frames);
  void add_rows(std::size_t lane, const StepRequest& request, const Vec3* x);
  void refine();
  LaneValue apply_matrix();
  double apply_row(std::size_t lane, const DistanceRow& row, const Vec3* x);
  void move();
  LaneMoves moves_of(std::vector<LaneTwist>& twists, std::vector<LaneValue>& angles) {
    return {twists.data(), angles.data()};
  }

  const BodyPlan& plan_;
  const LaneKernels& kernels_;
  std::array<LaneStepFrame, lane_count> frames_;
  LaneMask refined_ = 0;  ///< lanes with contacts, and so with conjugate gradients
  int conjugate_gradients_ = 0;
  std::vector<LaneBody> bodies_;
  std::vector<LaneInertia> inertia_;
  std::vector<LaneTurn> turns_;
  std::vector<LaneSpring> springs_;
  std::vector<TurnSpring> no_springs_;
  std::vector<LaneVector> x_, targets_;  ///< (places)
  std::vector<LaneMotion> motion_;
  std::vector<LaneTwist> forces_, left_, image_, twists_, direction_, sum_, first_;
  std::vector<LaneValue> left_of_turns_, angles_, direction_angles_, sum_angles_, first_angles_;
  LaneForest forest_{};
};

}  // namespace pliant
