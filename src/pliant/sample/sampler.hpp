// SPDX-License-Identifier: MIT
// A sampler chooses a target for each frame, and the contacts that are off in it. Targets are then
// resolved with exact geometry.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/course.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

class BodyPlan;
struct SampleOptions;

/// The target of one frame.
struct FrameRequest {
  std::vector<Vec3> targets;  ///< (N) Angstrom
  std::vector<Vec3> from;     ///< (N) whole start of the resolve; empty: where the frame begins
  /// (L) 1: the limit is switched off in this frame; empty: all are on
  std::vector<std::uint8_t> limits_off;
  Course course;  ///< the way to the targets; without a function: straight lines
  DrawnBy drawn_by = DrawnBy::other;
};

/// Makes requests for frames, each independent of all others. Several threads may call it at once.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Whether the amplitude says how far frames go.
  virtual bool has_amplitude() const { return true; }
  /// Number of steps from the beginning of a frame to its end, each requested and resolved.
  virtual int steps_a_frame() const { return 1; }
  /// Fills `request` for step `step` of a frame. `attempt` is the number of failed attempts at it.
  /// `now` (N) is where the step begins: the first at the start. Depends only on the arguments and
  /// the seed.
  virtual void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
                   FrameRequest& request) const = 0;
};

/// What samplers are made from; all must outlive them.
struct SamplerSetting {
  const Framework& framework;
  const BodyPlan& plan;
  std::span<const Vec3> start;  ///< (N) Angstrom
  const NetworkNodes& nodes;    ///< coarsened
  const SampleOptions& options;
};

}  // namespace pliant
