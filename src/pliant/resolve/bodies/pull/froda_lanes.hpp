// SPDX-License-Identifier: MIT
// Resolves many frames of one framework by careful steps, eight at once in SIMD lanes. When a frame
// is finished, the next one takes its lane. Frames are bit for bit those of a FrodaSolver.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "pliant/resolve/bodies/pull/froda_frame.hpp"
#include "pliant/resolve/bodies/pull/lane_step.hpp"

namespace pliant {

/// A frame to be resolved, as FrodaSolver::resolve takes it.
struct FrodaJob {
  FrodaPush push;
  std::span<Vec3> out;  ///< (N)
  FrodaResult result = {};
};

/// Not thread-safe.
class FrodaLanes {
 public:
  /// Whether frames of this plan profit from lanes: no loops are cut, and eight frames fit a
  /// processor's cache.
  static bool can_take(const BodyPlan& plan);

  /// Both must outlive it, and can_take(plan) must hold. Steps are those of a FrodaSolver of unit
  /// 1.
  FrodaLanes(const Framework& framework, const BodyPlan& plan,
             const LaneKernels& kernels = *lane_levels().front());

  FrodaLanes(const FrodaLanes&) = delete;  // points to its own members
  FrodaLanes& operator=(const FrodaLanes&) = delete;

  /// `options` must be careful.
  void resolve(std::span<FrodaJob> jobs, const FrodaOptions& options);

 private:
  struct Lane {
    std::unique_ptr<FrodaFrame> frame;
    FrodaJob* job = nullptr;  ///< null: idle
  };

  bool take_up(Lane& lane, std::span<FrodaJob>& waiting, const FrodaOptions& options);
  void step_together();
  void finish_alone(Lane& lane);
  static void leave(Lane& lane);

  const Framework& framework_;
  const BodyPlan& plan_;
  std::array<Lane, lane_count> lanes_;
  WorkingTrees all_;
  LaneStep together_;
  ArticulatedStep alone_;
};

}  // namespace pliant
