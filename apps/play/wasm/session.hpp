// SPDX-License-Identifier: MIT
// The session: one document and the walker that a person steers, with its history.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "document.hpp"
#include "kept_residuals.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/run/steered_walk.hpp"
#include "steps/made_step.hpp"

namespace pliant::play {

class Replay;

class Session {
 public:
  explicit Session(Document document);

  const Document& document() const { return document_; }
  const RunOptions& options() const { return walk_->options(); }
  const State& state() const { return walk_->state(); }
  const Framework& framework() const { return walk_->framework(); }
  const SteeredWalk& walk() const { return *walk_; }
  /// The document with its bars, contacts and rigid clusters after all edits.
  Document shown() const;
  /// Residuals of the bars, updated by the caller.
  KeptResiduals& residuals() { return *residuals_; }

  /// The present frame of the walker, measured.
  Frame frame() { return walk_->frame(); }

  /// Sets options. Throws OptionError; nothing is changed then.
  void set(const RunOptions& options);
  void pin(std::vector<Joint> joints);
  /// Cuts, adds and restores bars and contacts; undo takes it back like a step. Throws OptionError;
  /// nothing is changed then.
  void edit(const std::vector<FrameworkEdit>& edits);
  const std::vector<Joint>& pinned() const { return *pinned_; }
  /// Ends steps of a person that take longer, by the clock, and takes them back; 0: never.
  void set_step_limit(double milliseconds) { clock_->milliseconds = milliseconds; }
  const std::shared_ptr<StepClock>& clock() const { return clock_; }
  /// Makes one step.
  StepReport pull(const std::vector<JointForce>& forces);
  /// The same, watching the technique bar by bar. Throws OptionError if that is not possible; no
  /// step is made then.
  StepReport pull_watched(const std::vector<JointForce>& forces,
                          const std::function<void(const RepairedBar&)>& on_bar);
  /// Makes one step of the random pusher.
  StepReport wander();
  /// Walkers of the random pusher that start from the session without changing it; number k draws
  /// as walker k. They continue from the last call if `goes_on` and nothing has happened since;
  /// otherwise they start from the session.
  std::vector<std::unique_ptr<SteeredWalk>>& crowd(std::size_t walkers, bool goes_on);
  /// Repeats the last pull, also one that the clock has ended, from its start with other options,
  /// without changing the session; the report refers to the state `after` it. Throws OptionError if
  /// there was none.
  StepReport again(const RunOptions& options, State& after) const;
  /// Makes an event of a force file happen; of several steps the first alone. Returns what a step
  /// did. Settings that follow each other come into force together, with the next event of another
  /// kind: settle() brings them into force after the last.
  std::optional<StepReport> apply(const ForceEvent& event);
  void settle();
  /// Settings from which those of a force file begin.
  void begin_events(const RunOptions& options) { unsettled_ = options; }
  /// A force file that is being replayed; null: none.
  std::shared_ptr<Replay> replay;
  /// Takes back so many steps and edits, or all that are kept. Returns how many these were.
  std::size_t undo(std::size_t steps);
  /// All steps and edits that were not taken back, with their settings and pins.
  std::vector<ForceEvent> events() const;
  /// The header of a force file for the document and its model.
  ForceHeader force_header() const;

 private:
  /// What undo goes back to.
  struct Before {
    State state;
    std::shared_ptr<const EditedFramework> edited;
  };

  StepReport report(MadeStep step, const std::function<Frame()>& make);
  MadeStep step_of(std::vector<JointForce> forces, Act act) const;
  void keep(Before before, MadeStep step);
  void measure_anew();
  void start_again();

  Document document_;
  std::shared_ptr<const EditedFramework> measured_;  ///< what residuals_ are of; null: the document
  std::optional<KeptResiduals> residuals_;
  std::unique_ptr<SteeredWalk> walk_;
  std::shared_ptr<const RunOptions> options_;
  std::shared_ptr<const std::vector<Joint>> pinned_;
  std::vector<MadeStep> done_;       ///< all steps and edits
  std::optional<MadeStep> stopped_;  ///< the last step, where the clock has ended it
  std::deque<Before> befores_;       ///< before the last ones
  std::size_t most_befores_;
  std::vector<std::unique_ptr<SteeredWalk>> crowd_;
  std::shared_ptr<StepClock> clock_ = std::make_shared<StepClock>();
  std::optional<RunOptions> unsettled_;         ///< settings that are not in force yet
  std::shared_ptr<const RunOptions> start_by_;  ///< made the start whole; null: the usual ones
  double longest_step_ = 0.0;                   ///< Angstrom, as MadeStep
};

/// The fields of a frame in a reply, without its positions.
Json fields_of(const Frame& frame);

/// The open session. Throws OptionError if there is none.
Session& session();
/// Opens a session in place of it. Returns the reply of the call `open`.
Reply begin_session(Document document);

}  // namespace pliant::play
