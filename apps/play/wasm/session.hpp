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

namespace pliant::play {

/// The result of a step, as far as a page shows it.
struct StepReport {
  Frame frame;
  std::vector<Vec3> pushed;  ///< (N) Angstrom, after the push, before anything was resolved
  double seconds = 0.0;      ///< for push, resolve and measuring
};

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
  /// Repeats the last pull from its start with other options, without changing the session. Throws
  /// OptionError if there was none.
  StepReport again(const RunOptions& options, State& after) const;
  /// Does what an event of a force file says, and shows each step of it. Throws OptionError.
  void apply(const ForceEvent& event, const std::function<void(const StepReport&)>& show);
  /// Takes back so many steps and edits, or all that are kept. Returns how many these were.
  std::size_t undo(std::size_t steps);
  /// All steps and edits that were not taken back, with their settings and pins.
  std::vector<ForceEvent> events() const;
  /// The header of a force file for the document and its model.
  ForceHeader force_header() const;

 private:
  enum class Act : std::uint8_t { pull, wander, edit };

  /// A step or an edit, and its settings.
  struct Done {
    std::shared_ptr<const RunOptions> options;
    std::shared_ptr<const std::vector<Joint>> pinned;
    std::shared_ptr<const EditedFramework> edited;
    std::vector<JointForce> forces;
    Act act = Act::pull;
  };
  /// What undo goes back to.
  struct Before {
    State state;
    std::shared_ptr<const EditedFramework> edited;
  };

  StepReport report(std::vector<JointForce> forces, Act act, const std::function<Frame()>& step);
  void keep(Before before, std::vector<JointForce> forces, Act act);
  void measure_anew();

  Document document_;
  std::shared_ptr<const EditedFramework> measured_;  ///< what residuals_ are of; null: the document
  std::optional<KeptResiduals> residuals_;
  std::unique_ptr<SteeredWalk> walk_;
  std::shared_ptr<const RunOptions> options_;
  std::shared_ptr<const std::vector<Joint>> pinned_;
  std::vector<Done> done_;
  std::deque<Before> befores_;  ///< the last ones
  std::size_t most_befores_;
  std::vector<std::unique_ptr<SteeredWalk>> crowd_;
};

/// The fields of a frame in a reply, without its positions.
Json fields_of(const Frame& frame);

/// The open session. Throws OptionError if there is none.
Session& session();
/// Opens a session in place of it. Returns the reply of the call `open`.
Reply begin_session(Document document);

}  // namespace pliant::play
