// SPDX-License-Identifier: MIT
#include "pliant/run/replay_events.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/run/run_fields.hpp"
#include "pliant/run/steered_walk.hpp"

namespace pliant {
namespace {

RunOptions beginning(const ReplayOptions& options) {
  RunOptions run;
  run.resolve.should_stop = options.should_stop;
  run.log = options.log;
  return run;
}

/// Frames of a file are judged by one tolerance: the loosest of any step.
class LoosestTolerance {
 public:
  void note(const Tolerance& one) {
    if (one.length > 0.0)
      length_ = std::max(length_, one.length);
    else
      relative_ = std::max(relative_, one.relative);
    loosest_.limit = std::max(loosest_.limit, one.limit);
    loosest_.overlap = std::max(loosest_.overlap, one.overlap);
  }

  /// Where steps had both kinds, as a length.
  Tolerance of(const Framework& framework) const {
    Tolerance all = loosest_;
    all.relative = relative_;
    double longest = 0.0;
    for (double rest : framework.rest_lengths()) longest = std::max(longest, rest);
    if (length_ > 0.0) all.length = std::max(length_, relative_ * longest);
    return all;
  }

 private:
  double relative_ = 0.0, length_ = 0.0;
  Tolerance loosest_;
};

/// Whether the events say under which settings the start is made whole.
bool starts_by_itself(std::span<const ForceEvent> events) {
  return std::ranges::any_of(events, [](const ForceEvent& event) {
    return std::holds_alternative<StartWalk>(event.what);
  });
}

class Replaying {
 public:
  Replaying(const Framework& framework, const State& state, const ReplayOptions& options,
            const std::vector<Observer>& observers)
      : options_(options), observers_(observers), walk_(framework, state, beginning(options)) {}

  void check(std::span<const ForceEvent> events) {
    makes_steps_ = false;
    apply_all(events);
  }

  RunSummary run(std::span<const ForceEvent> events) {
    last_step_ = walk_.state().step + steps_of(events);
    if (!starts_by_itself(events)) show(walk_.start());
    apply_all(events);
    RunSummary summary = walk_.summary();
    summary.frames = shown_;
    summary.stopped_by_caller = is_stopped_;
    return summary;
  }

  const State& state() const { return walk_.state(); }

 private:
  /// Settings that follow each other are in force together: one alone might make no sense.
  void apply_all(std::span<const ForceEvent> events) {
    RunOptions wanted = walk_.options();
    const ForceEvent* unsettled = nullptr;
    for (const ForceEvent& event : events) {
      if (is_stopped_) return;
      if (const auto* set = std::get_if<SetOption>(&event.what)) {
        at_line(event, [&] { set_run_field(wanted, set->name, set->value); });
        unsettled = &event;
        continue;
      }
      if (unsettled != nullptr) at_line(*unsettled, [&] { walk_.set(wanted); });
      unsettled = nullptr;
      at_line(event, [&] { std::visit([&](const auto& what) { apply(what); }, event.what); });
    }
    if (unsettled != nullptr) at_line(*unsettled, [&] { walk_.set(wanted); });
  }

  void at_line(const ForceEvent& event, const std::function<void()>& work) {
    try {
      work();
    } catch (const OptionError& error) {
      fail({options_.file, event.line}, error.what());
    }
  }

  void apply(const SetOption&) {}
  void apply(const PinJoints& pins) { walk_.pin(pins.joints); }
  void apply(const PullStep& pull) {
    for (std::int64_t k = 0; makes_steps_ && k < pull.count && !is_stopped_; ++k)
      show(walk_.pull(pull.forces));
  }
  void apply(const WanderSteps& wander) {
    for (std::int64_t k = 0; makes_steps_ && k < wander.count && !is_stopped_; ++k)
      show(walk_.wander(wander.forces));
  }
  void apply(const HoldBack& hold) { walk_.hold_back(hold.longest_step); }
  void apply(const FrameworkEdit& edit) { walk_.edit({&edit, 1}); }
  void apply(const StartWalk&) {
    if (makes_steps_) show(walk_.start());
  }

  void show(const Frame& frame) {
    is_stopped_ =
        frame.stop == Stop::stopped_by_caller || (options_.should_stop && options_.should_stop());
    if (frame.step % options_.every != 0 && frame.step < last_step_ && !is_stopped_) return;
    ++shown_;
    for (const Observer& observer : observers_)
      if (observer(frame)) is_stopped_ = true;
  }

  const ReplayOptions& options_;
  const std::vector<Observer>& observers_;
  SteeredWalk walk_;
  std::int64_t last_step_ = 0, shown_ = 0;
  bool is_stopped_ = false, makes_steps_ = true;
};

}  // namespace

void check_events(const Framework& framework, const State& state,
                  std::span<const ForceEvent> events, std::string_view file) {
  ReplayOptions options;
  options.file = file;
  Replaying(framework, state, options, {}).check(events);
}

RunSummary replay_events(const Framework& framework, State& state,
                         std::span<const ForceEvent> events, const ReplayOptions& options,
                         const std::vector<Observer>& observers) {
  Replaying replaying(framework, state, options, observers);
  const RunSummary summary = replaying.run(events);
  state = replaying.state();
  return summary;
}

RunOptions options_after(RunOptions options, std::span<const ForceEvent> events,
                         const Framework& framework) {
  LoosestTolerance loosest;
  if (!starts_by_itself(events)) loosest.note(options.resolve.tolerance);
  for (const ForceEvent& event : events) {
    if (const auto* set = std::get_if<SetOption>(&event.what))
      set_run_field(options, set->name, set->value);
    else
      loosest.note(options.resolve.tolerance);
  }
  options.resolve.tolerance = loosest.of(framework);
  options.steps = steps_of(events);
  return options;
}

}  // namespace pliant
