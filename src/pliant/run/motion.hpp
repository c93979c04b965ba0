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

/// What a Motion does. Checked once, when it is made.
struct MotionOptions {
  Technique technique = {};
  ResolveOptions resolve = {};  ///< its walker is not looked at
  std::vector<std::string> push = {
      "force"};                         ///< names in pushers(), in the order in which they act
  PerturbOptions perturb = {};          ///< of all of them
  std::vector<JointForce> replay = {};  ///< of pusher `replay`: one force a step
  std::int64_t replay_from = 0;         ///< the step after which replays and guides begin
  Guide guide = {};                     ///< of pushers `rock`, `pull` and `pair_distance`
  Log log = {};
  std::vector<std::int64_t> replay_counts = {};  ///< (S) forces of each step; empty: one
};

/// Throws OptionError naming the option, its value and its range.
void check(const MotionOptions& options);

/// One walker. The state is all that its way depends on: a Motion made with a copy of state() goes
/// on bit by bit as this one does, whatever the technique and the pushers of the table, also where
/// a step did not converge. Call start() to begin; step() alone to go on. Not for two threads at
/// once.
class Motion {
 public:
  /// The framework must outlive it. Random draws are those of `walker`. Throws OptionError, and
  /// InputError for positions that cannot carry the framework.
  Motion(const Framework& framework, State state, const MotionOptions& options = {},
         std::uint64_t walker = 0);
  /// Steps on a state that lives elsewhere, and longer.
  Motion(const Framework& framework, std::reference_wrapper<State> state,
         const MotionOptions& options = {}, std::uint64_t walker = 0);
  ~Motion();
  Motion(Motion&&) noexcept;

  /// Acts in each step after the pushers that are there already.
  void add(std::shared_ptr<Pusher> pusher);

  /// Resolves the positions first if a bar is broken, at rest afterwards.
  Frame start();
  /// Pushes and resolves. A step that does not converge is told as such. Of one with
  /// Stop::not_finite the push is taken back; one that should_stop cut short is taken back whole:
  /// the state is as before, and the frame says Stop::stopped_by_caller. Throws what a pusher
  /// throws; the state is then as before the step.
  Frame step();

  /// step() without the look at all bars that a frame needs. False if the step was cut short.
  bool advance();
  /// Where the walker is, measured. Valid until the next step.
  Frame frame();
  /// What pushed in the last step.
  const Push& pushed() const;

  const State& state() const;
  /// The state, to be changed before the next step; ask again each time.
  State& change_state();
  /// Its frames are those that have been asked for.
  const RunSummary& summary() const;
  /// Whether should_stop or stop() asked for an end, or all pushers have nothing more to push.
  /// step() may be called all the same.
  bool is_over() const;
  void stop();

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace pliant
