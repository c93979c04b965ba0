// SPDX-License-Identifier: MIT
// SteeredWalk (interactive simulation): a Motion controlled by a person, who pulls on joints, pins
// them and changes settings between steps. Used by the page and by force files with events.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/edits.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// The same steps from the same start give the same bits, whenever they are asked for. Not
/// thread-safe.
class SteeredWalk {
 public:
  /// Only the options technique, resolve, perturb and perturb_options are used. The framework must
  /// outlive it. Throws as Motion.
  SteeredWalk(const Framework& framework, State state, const RunOptions& options = {});
  SteeredWalk(const SteeredWalk&) = delete;
  SteeredWalk& operator=(const SteeredWalk&) = delete;

  /// Resolves the positions first if a bar is broken; the walker is then at rest.
  Frame start();
  /// Makes a step with only these forces, by move_by_verlet. Throws OptionError for a force that is
  /// not finite or on a joint that does not exist; the state is then unchanged.
  Frame pull(std::span<const JointForce> forces);
  /// Makes a step of the pusher options().perturb; these forces act after it, as in pull().
  Frame wander(std::span<const JointForce> forces = {});

  /// The present frame, measured. Valid until the next step.
  Frame frame();

  /// Sets the options from the next step on. Throws OptionError, also if the technique cannot
  /// resolve this framework; nothing is changed then.
  void set(const RunOptions& options);
  /// Holds these joints in place of the earlier ones, besides those that the framework has pinned:
  /// they take no part of any correction. Throws as set(), and for a joint that does not exist.
  void pin(std::span<const Joint> joints);
  /// Cuts, adds and restores bars and contacts, from the next step on. Throws as edited() and
  /// set(); nothing is changed then.
  void edit(std::span<const FrameworkEdit> edits);
  /// From now on no force moves its joint by more than `longest_step` (Angstrom) in a step, as in
  /// Steering. Throws OptionError if that is not above 0.
  void hold_back(double longest_step);
  /// Calls `on_bar` for each bar that a sweep repairs, from the next step on; empty: no longer.
  /// Throws as set(): only orderings visit bar by bar.
  void watch(std::function<void(const RepairedBar&)> on_bar);
  /// Calls `look` with the positions after the push of each step, before the resolve; empty: no
  /// longer.
  void look_at_push(std::function<void(std::span<const Vec3>)> look);
  /// Replaces the state, for example by an earlier one: the next step continues from there.
  void put(State state);
  /// The same, with what held it then; null: no edits.
  void put(State state, std::shared_ptr<const EditedFramework> edited);

  /// Another walk that goes on as this one would, with its settings, pins and edits, and leaves it
  /// where it is.
  std::unique_ptr<SteeredWalk> branch() const;

  const RunOptions& options() const { return options_; }
  /// The framework after all edits, with the joints that are held.
  const Framework& framework() const { return held_ ? *held_ : without_pins(); }
  /// The edits and what they have made of the framework; null: none.
  const std::shared_ptr<const EditedFramework>& edited() const { return edited_; }
  std::span<const Joint> pinned() const { return pinned_; }
  const State& state() const { return state_; }
  /// How the resolve of the last step ended, before anything was taken back: where should_stop cut
  /// it short, its worst bar then.
  const ResolveSummary& resolved() const;
  /// Summary of all steps.
  RunSummary summary() const;

 private:
  enum class Pushing : std::uint8_t { by_hand, at_random };

  Motion& motion(Pushing by);
  std::unique_ptr<Motion> made(const Framework& framework, const RunOptions& options, Pushing by);
  void replace(std::unique_ptr<Motion> motion);
  const Framework& without_pins() const { return edited_ ? edited_->framework : framework_; }
  void renew(RunOptions options);
  void hold(std::shared_ptr<const EditedFramework> edited, std::span<const Joint> pinned);

  const Framework& framework_;
  State state_;
  RunOptions options_;
  std::vector<Joint> pinned_;
  std::shared_ptr<const EditedFramework> edited_;  ///< null: no edits
  std::shared_ptr<const Framework> held_;          ///< null: no joint is held
  std::function<void(std::span<const Vec3>)> look_;
  std::shared_ptr<Steering> hand_;
  Pushing pushing_ = Pushing::by_hand;
  std::unique_ptr<Motion> motion_;  ///< null until it is needed
  RunSummary done_;                 ///< summary of the motions before it
};

}  // namespace pliant
