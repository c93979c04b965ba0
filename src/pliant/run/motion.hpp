// SPDX-License-Identifier: MIT
// Motion (simulation of one walker): start, then step by step.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/perturb/pusher.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/run/run_summary.hpp"

namespace pliant {

/// Options of a Motion. Checked once, when it is made.
struct MotionOptions {
  Technique technique = {};
  ResolveOptions resolve = {};  ///< its walker is ignored
  std::vector<std::string> push = {
      "force"};                 ///< names in pushers(), in the order in which they act
  PerturbOptions perturb = {};  ///< for all of them
  /// for pusher `replay`: forces, one a step or by replay_counts
  std::vector<JointForce> replay = {};
  std::int64_t replay_from = 0;  ///< the step after which replays and guides begin
  Guide guide = {};              ///< for pushers `rock`, `pull` and `pair_distance`
  Log log = {};
  std::vector<std::int64_t> replay_counts = {};  ///< (S) number of forces in each step; empty: one
};

/// Throws OptionError naming the option, its value and its range.
void check(const MotionOptions& options);

/// One walker. Its further course depends only on the state: a Motion made with a copy of state()
/// continues bit by bit as this one does, whatever the technique and the pushers of the table, even
/// after a step that did not converge. Call start() to begin, step() alone to continue. Not
/// thread-safe.
class Motion {
 public:
  /// The framework must outlive it. Random draws are those of `walker`. Throws OptionError, and
  /// InputError for positions that cannot carry the framework.
  Motion(const Framework& framework, State state, const MotionOptions& options = {},
         std::uint64_t walker = 0);
  /// Moves a state that is stored elsewhere, which must outlive it.
  Motion(const Framework& framework, std::reference_wrapper<State> state,
         const MotionOptions& options = {}, std::uint64_t walker = 0);
  ~Motion();
  Motion(Motion&&) noexcept;

  /// Adds a pusher, which acts in each step after the earlier ones.
  void add(std::shared_ptr<Pusher> pusher);

  /// Resolves the positions first if a bar is broken; the walker is then at rest.
  Frame start();
  /// Pushes and resolves. The frame says whether the step converged. With Stop::not_finite the push
  /// is taken back; if should_stop cut the step short, all of it is: the state is unchanged, and
  /// the frame says Stop::stopped_by_caller. Throws what a pusher throws; the state is then
  /// unchanged.
  Frame step();

  /// step() without measuring all bars for a frame. Returns false if the step was cut short.
  bool advance();
  /// The present frame, measured. Valid until the next step.
  Frame frame();
  /// How the resolve of the last step ended, before anything was taken back.
  const ResolveSummary& resolved() const;
  /// The push of the last step.
  const Push& pushed() const;

  const State& state() const;
  /// The state, to be changed before the next step; call it again each time.
  State& change_state();
  /// Summary of the steps; its frames are those that were asked for.
  const RunSummary& summary() const;
  /// Whether should_stop or stop() asked for an end, or all pushers have ended. step() may still be
  /// called.
  bool is_over() const;
  void stop();

 private:
  struct WalkPlan;
  std::unique_ptr<WalkPlan> plan_;
};

}  // namespace pliant
