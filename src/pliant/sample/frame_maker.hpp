// SPDX-License-Identifier: MIT
// Makes frames: asks a sampler, resolves, and repeats where that fails. Frames of one step
// are resolved in SIMD lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/pull/froda_lanes.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "pliant/sample/sampler.hpp"

namespace pliant {

/// A frame and how it was made.
struct MadeFrame {
  bool is_made = false;
  std::vector<Vec3> positions;           ///< (N)
  std::vector<std::uint8_t> limits_off;  ///< (L) or empty
  double max_residual = 0.0, rms_residual = 0.0;
  BarIndex worst_bar = 0;
  DrawnBy drawn_by = DrawnBy::other;
  FrodaResult result;  ///< of the last step
  double off_target = 0.0;
  int redraws = 0;          ///< number of draws after the first, over all steps
  bool is_rescued = false;  ///< resolved by blind or patient steps, or drawn again
  std::int64_t steps = 0;
  double cpu_seconds = 0.0;
};

/// Not thread-safe: each thread has its own.
class FrameMaker {
 public:
  /// Bars are whole to rounding by how units move: more is an error, and no frame (share of
  /// length).
  static constexpr double most_residual = 1e-9;

  /// All must outlive it.
  FrameMaker(const Framework& framework, const BodyPlan& plan, const Sampler& sampler);

  /// Makes frame `number`, which begins at `start`.
  void make(std::int64_t number, std::span<const Vec3> start, MadeFrame& out);
  /// Whether it has lanes: then each frame takes one step.
  bool has_lanes() const { return lanes_ != nullptr; }
  /// Makes frames from `first` on, with the bits of make(). Only with lanes.
  void make_many(std::int64_t first, std::span<const Vec3> start, std::span<MadeFrame> out);

 private:
  bool draw_again(std::int64_t number, int step, std::span<const Vec3> now, MadeFrame& out);
  bool rescue(std::span<const Vec3> from, MadeFrame& out);
  void finish(MadeFrame& out) const;
  static std::span<const Vec3> from(const FrameRequest& request, std::span<const Vec3> now);
  static FrodaPush push_of(const FrameRequest& request, std::span<const Vec3> now);
  bool make_step(std::int64_t number, int step, std::span<const Vec3> now, MadeFrame& out);
  bool resolve(std::span<const Vec3> now, const FrodaOptions& options, MadeFrame& out);
  void measure_bars(MadeFrame& out) const;

  const Framework& framework_;
  const Sampler& sampler_;
  FrodaSolver solver_;
  std::unique_ptr<FrodaLanes> lanes_;  ///< null: frames are made one by one
  FrameRequest request_;
  std::vector<FrameRequest> requests_;  ///< of make_many()
  std::vector<FrodaJob> jobs_;
  std::vector<Vec3> now_;
};

}  // namespace pliant
