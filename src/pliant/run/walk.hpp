// SPDX-License-Identifier: MIT
// One walker on its way through a run, step by step, so that several can step together.
#pragma once

#include <optional>
#include <vector>

#include "pliant/run/run.hpp"

namespace pliant {

class Walk {
 public:
  /// All outlive it. `resolver` may be shared by walkers that take turns.
  Walk(const Framework& framework, WalkerRun& walker, const RunOptions& options,
       Resolver& resolver);

  /// Shows the start, resolved first if it is broken.
  void begin();
  bool is_over() const { return stopping_ || state_.step >= last_step_; }

  /// A step is push(), then resolve() or whatever else resolves positions(), then finish().
  void push();
  /// Where the technique begins, if every bar has to be looked at; none where a push of one joint
  /// left most of them alone or broke a number.
  std::optional<Joint> whole_resolve_from() const;
  ResolveSummary resolve();
  void finish(ResolveSummary resolved);
  /// finish() of a resolve beside others, whose time is in `resolved` and not yet in the summary.
  void finish_together(const ResolveSummary& resolved);
  /// Back to the last whole step if a push has not been finished.
  void take_back_push();

  std::uint64_t number() const { return number_; }
  std::int64_t step() const { return state_.step; }
  /// Whether observers will see this step, unless the walker is asked to stop.
  bool shows_this_step() const;
  std::span<Vec3> positions() { return state_.positions; }
  std::span<const Vec3> previous() const { return state_.previous; }
  const RunSummary& summary() const { return summary_; }

 private:
  std::int64_t steps_to_do() const;
  void undo_step();
  ResidualSummary measured() const;
  std::string what_is_missed(const ResidualSummary& start) const;
  void measure_all(ResolveSummary& resolved) const;
  bool is_finite_after_push() const;
  Joint root() const;
  ResolveSummary resolve_all(Joint root);
  ResolveSummary resolve_near(Joint root);
  void note(const ResolveSummary& resolved);
  void show(ResolveSummary resolved);

  const Framework& framework_;
  State& state_;
  std::uint64_t number_;
  const RunOptions& options_;
  const std::vector<Observer>& observers_;
  const std::function<void(const Push&)>& on_push_;
  const Log& log_;
  const PerturbationEntry& perturbation_;
  Resolver& resolver_;
  RunSummary summary_;
  std::int64_t last_step_;
  double time_before_ = 0.0;  ///< the push
  Push push_;
  bool stopping_ = false;
  bool is_pushed_ = false;    ///< and not finished
  bool is_whole_ = false;     ///< all bars, before the push
  bool knows_moved_ = false;  ///< no joint but those of moved_ has left its previous position
  std::vector<Joint> moved_;
};

}  // namespace pliant
