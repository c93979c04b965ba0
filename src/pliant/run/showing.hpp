// SPDX-License-Identifier: MIT
// Shows one walker to its observers.
#pragma once

#include <algorithm>

#include "pliant/run/run_options.hpp"
#include "pliant/run/stopwatch.hpp"

namespace pliant {

/// Shows a walker, a Motion or a Walk, to the observers of a run.
class Showing {
 public:
  /// What is referred to must outlive it; `start` is the first step of the walker.
  Showing(const std::vector<Observer>& observers, const std::function<void(const Push&)>& on_push,
          const Onlooker& onlooker, const RunOptions& options, std::int64_t start)
      : observers_(observers),
        on_push_(on_push),
        onlooker_(onlooker),
        every_(options.every),
        options_(options) {
    const std::int64_t replayed = replayed_steps(options);
    last_step_ = start + (replayed > 0 ? std::min(options.steps, replayed) : options.steps);
  }

  template <class Walker>
  bool is_over(const Walker& walker) const {
    return walker.is_over() || walker.state().step >= last_step_ || has_arrived(walker.state());
  }

  /// Whether this step is shown even if nobody asks to stop.
  bool is_due(std::int64_t step) const { return step >= last_step_ || step % every_ == 0; }

  /// Shows a step that has been done to whoever wants to see it.
  template <class Walker>
  void tell(Walker& walker) {
    if (on_push_) on_push_(walker.pushed());
    const bool is_wanted = onlooker_.wants && onlooker_.wants(walker.state().step);
    const bool is_shown = is_over(walker) || is_due(walker.state().step);
    if (!is_wanted && !is_shown) return;
    const Frame frame = walker.frame();
    if (is_wanted) look(frame);
    if (is_shown) show(walker, frame);
  }

  template <class Walker>
  void show_start(Walker& walker, const Frame& frame) {
    if (onlooker_.wants && onlooker_.wants(frame.step)) look(frame);
    show(walker, frame);
  }

  /// `summary` with the time that observers took, and the number of frames that they were shown.
  RunSummary with_observers(RunSummary summary) const {
    summary.frames = frames_;
    summary.observe_seconds += seconds_;
    summary.seconds += seconds_;
    return summary;
  }

 private:
  bool has_arrived(const State& state) const {
    return replayed_steps(options_) == 0 && pliant::has_arrived(options_.guide, state.positions);
  }

  template <class Walker>
  void show(Walker& walker, const Frame& frame) {
    const Stopwatch watch(seconds_);
    ++frames_;
    for (const Observer& observer : observers_)
      if (observer(frame)) walker.stop();
  }

  void look(const Frame& frame) {
    const Stopwatch watch(seconds_);
    onlooker_.look(frame);
  }

  const std::vector<Observer>& observers_;
  const std::function<void(const Push&)>& on_push_;
  const Onlooker& onlooker_;
  std::int64_t every_, last_step_ = 0;
  const RunOptions& options_;
  double seconds_ = 0.0;
  std::int64_t frames_ = 0;
};

/// Options for each walker of a run, from the step `start` on.
MotionOptions motion_of(const RunOptions& options, std::int64_t start, const Log& log);

}  // namespace pliant
