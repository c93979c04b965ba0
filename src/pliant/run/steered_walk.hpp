// SPDX-License-Identifier: MIT
// SteeredWalk (interactive simulation): a Motion in the hands of a person, who pulls on joints,
// pins them and changes settings from one step to the next. What a page does, and what a force file
// with events repeats.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/perturb/steering.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// The same steps on the same start give the same bits, whenever they were asked for. Not for two
/// threads at once.
class SteeredWalk {
 public:
  /// Of the options technique, resolve, perturb and perturb_options count. The framework must
  /// outlive it. Throws as Motion.
  SteeredWalk(const Framework& framework, State state, const RunOptions& options = {});
  SteeredWalk(const SteeredWalk&) = delete;
  SteeredWalk& operator=(const SteeredWalk&) = delete;

  /// Resolves the positions first if a bar is broken, at rest afterwards.
  Frame start();
  /// A step in which these forces act, by move_by_verlet, and no others. Throws OptionError for a
  /// force that is not finite or on a joint that does not exist; the state is then as before.
  Frame pull(std::span<const JointForce> forces);
  /// A step of the pusher that options().perturb names; these forces act after it, as in pull().
  Frame wander(std::span<const JointForce> forces = {});

  /// Where the walker is, measured. Valid until the next step.
  Frame frame();

  /// From the next step on. Throws OptionError, also where the technique cannot resolve this
  /// framework; all is then as before.
  void set(const RunOptions& options);
  /// These joints are held, in place of those before, besides those that the framework has pinned:
  /// they take no part of any correction. Throws as set(), and for a joint that does not exist.
  void pin(std::span<const Joint> joints);
  /// No force moves its joint by more than `longest_step` (Angstrom) in a step from now on, as
  /// Steering has it. Throws OptionError if that is not above 0.
  void hold_back(double longest_step);
  /// Shows each bar that a sweep repairs from the next step on; none: no longer. Throws as set():
  /// only orderings go bar by bar.
  void watch(std::function<void(const RepairedBar&)> on_bar);
  /// Told the positions of each step after the push, before anything is resolved; none: no longer.
  void look_at_push(std::function<void(std::span<const Vec3>)> look);
  /// Another state, such as one from before: the next step goes on from there.
  void put(State state);

  const RunOptions& options() const { return options_; }
  /// With the joints that are held.
  const Framework& framework() const { return held_ ? *held_ : framework_; }
  std::span<const Joint> pinned() const { return pinned_; }
  const State& state() const { return state_; }
  /// What all steps did.
  RunSummary summary() const;

 private:
  enum class Pushing : std::uint8_t { by_hand, at_random };

  Motion& motion(Pushing by);
  std::unique_ptr<Motion> made(const Framework& framework, const RunOptions& options, Pushing by);
  void replace(std::unique_ptr<Motion> motion);
  void renew(std::shared_ptr<const Framework> held, RunOptions options);

  const Framework& framework_;
  State state_;
  RunOptions options_;
  std::vector<Joint> pinned_;
  std::shared_ptr<const Framework> held_;  ///< null: no joint is held
  std::function<void(std::span<const Vec3>)> look_;
  std::shared_ptr<Steering> hand_;
  Pushing pushing_ = Pushing::by_hand;
  std::unique_ptr<Motion> motion_;  ///< null: to be made
  RunSummary done_;                 ///< by those before it
};

}  // namespace pliant
