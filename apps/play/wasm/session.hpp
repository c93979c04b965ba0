// SPDX-License-Identifier: MIT
// The session: one document and the walker that a person steers, with what was done so far.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "document.hpp"
#include "kept_residuals.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/run/steered_walk.hpp"

namespace pliant::play {

/// What a step did, as far as a page shows it.
struct StepReport {
  Frame frame;
  std::vector<Vec3> pushed;  ///< (N) Angstrom, after the push, before anything was resolved
  double seconds = 0.0;      ///< of push, resolve and measuring
};

class Session {
 public:
  explicit Session(Document document);

  const Document& document() const { return document_; }
  const RunOptions& options() const { return walk_->options(); }
  const State& state() const { return walk_->state(); }
  const Framework& framework() const { return walk_->framework(); }
  /// Of bars, where the caller looks.
  KeptResiduals& residuals() { return residuals_; }

  /// Where the walker stands, measured.
  Frame frame() { return walk_->frame(); }

  /// Throws OptionError; all is then as before.
  void set(const RunOptions& options);
  void pin(std::vector<Joint> joints);
  /// One step.
  StepReport pull(const std::vector<JointForce>& forces);
  /// The same, and the technique is watched bar by bar. Throws OptionError if it cannot be; no step
  /// was done then.
  StepReport pull_watched(const std::vector<JointForce>& forces,
                          const std::function<void(const RepairedBar&)>& on_bar);
  /// One step of the random pusher.
  StepReport wander();
  /// Walkers of the random pusher that leave the session where it is; number k draws as walker k.
  /// They are where they were at the last call, if they are to go on and nothing has happened
  /// since; else they begin where the session is.
  std::vector<std::unique_ptr<SteeredWalk>>& crowd(std::size_t walkers, bool goes_on);
  /// The last pull once more with other options, from where it began; the session stays as it is.
  /// Throws OptionError if there was none.
  StepReport again(const RunOptions& options, State& after) const;
  /// Takes so many steps back, or all that are remembered; how many those were.
  std::size_t undo(std::size_t steps);
  /// All steps that were not taken back, with their settings and pins.
  std::vector<ForceEvent> events() const;
  /// What these are for: the document and its model.
  ForceHeader force_header() const;

 private:
  /// A step: what it was done with.
  struct Done {
    std::shared_ptr<const RunOptions> options;
    std::shared_ptr<const std::vector<Joint>> pinned;
    std::vector<JointForce> forces;
    bool is_pull = true;
  };

  StepReport report(Done done, const std::function<Frame()>& step);

  Document document_;
  KeptResiduals residuals_;
  std::unique_ptr<SteeredWalk> walk_;
  std::shared_ptr<const RunOptions> options_;
  std::shared_ptr<const std::vector<Joint>> pinned_;
  std::vector<Done> done_;     ///< all steps
  std::deque<State> befores_;  ///< the states before the last ones
  std::size_t most_befores_;
  std::vector<std::unique_ptr<SteeredWalk>> crowd_;
};

/// What a reply tells of a frame, without its positions.
Json fields_of(const Frame& frame);

/// The session that is open. Throws OptionError if there is none.
Session& session();
/// Opens another one in place of it, and replies as the call `open`.
Reply begin_session(Document document);

}  // namespace pliant::play
