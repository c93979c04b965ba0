// SPDX-License-Identifier: MIT
// One step of a walk, as far as a page shows it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pliant/perturb/push.hpp"
#include "pliant/run/steered_walk.hpp"
#include "steps/step_clock.hpp"

namespace pliant::play {

enum class Act : std::uint8_t { pull, wander, edit };

/// A step or an edit of the framework, and its settings.
struct MadeStep {
  std::shared_ptr<const RunOptions> options;
  std::shared_ptr<const std::vector<Joint>> pinned;
  std::shared_ptr<const EditedFramework> edited;  ///< null: no edits
  std::vector<JointForce> forces;
  Act act = Act::pull;
  double longest_step = 0.0;  ///< Angstrom, as HoldBack; 0: as long as a force makes it
};

/// The result of a step.
struct StepReport {
  Frame frame;
  std::vector<Vec3> pushed;  ///< (N) Angstrom, after the push, before anything was resolved
  double seconds = 0.0;      ///< for push, resolve and measuring
  ResolveSummary resolved;   ///< how the resolve ended, before anything was taken back

  /// The clock has ended it: it was taken back, and nothing has been done.
  bool is_stopped() const { return frame.stop == Stop::stopped_by_caller; }
};

/// Makes a step of `walk` under the clock.
StepReport make_step(SteeredWalk& walk, StepClock& clock, const std::function<Frame()>& step);

/// The same, watching the technique bar by bar. Throws OptionError if that is not possible; no step
/// is made then.
StepReport make_watched(SteeredWalk& walk, const std::function<void(const RepairedBar&)>& on_bar,
                        const std::function<StepReport()>& step);

}  // namespace pliant::play
