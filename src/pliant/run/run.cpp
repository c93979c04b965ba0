// SPDX-License-Identifier: MIT
#include "pliant/run/run.hpp"

#include <algorithm>
#include <chrono>

#include "pliant/base/error.hpp"
#include "pliant/framework/check_positions.hpp"

namespace pliant {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time until its end to a sum of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

/// One run: what its steps share.
class Run {
 public:
  Run(const Framework& framework, State& state, const RunOptions& options,
      const std::vector<Observer>& observers)
      : framework_(framework),
        state_(state),
        options_(options),
        observers_(observers),
        perturbation_(find_perturbation(options.perturb)),
        resolver_(framework, options.technique, options.resolve) {}

  RunSummary all() {
    {
      const Stopwatch watch(summary_.seconds);
      begin();
      const std::int64_t last = state_.step + steps_to_do();
      while (!stopping_ && state_.step < last) step(state_.step + 1 == last);
    }
    return summary_;
  }

 private:
  std::int64_t steps_to_do() const {
    if (options_.replay.empty()) return options_.steps;
    return std::min(options_.steps, static_cast<std::int64_t>(options_.replay.size()));
  }

  /// A start that misses its rest lengths is resolved before anything else.
  void begin() {
    const ResidualSummary start = measure(framework_, state_.positions, options_.resolve.tolerance);
    ResolveSummary resolved;
    resolved.stop = Stop::converged;
    resolved.sweeps = resolved.projections = 0;
    resolved.max_residual = start.max_relative;
    resolved.rms_residual = start.rms_relative;
    resolved.worst_bar = start.worst_bar;
    if (!start.within) {
      options_.log.warn("the start misses its rest lengths, worst bar " +
                        framework_.label(framework_.bars()[start.worst_bar]) + " by " +
                        std::to_string(start.max_length) + " Angstrom: resolved first");
      resolved = resolve(0);
      state_.previous = state_.positions;
      note(resolved);
    }
    show(resolved, {});
  }

  void step(bool is_last) {
    const Push push = perturb();
    ++state_.step;
    state_.time += options_.perturb_options.timestep;
    const ResolveSummary resolved =
        resolve(push.root_joint == no_joint ? 0 : static_cast<Joint>(push.root_joint));
    if (resolved.stop == Stop::stopped_by_caller) return undo_step();
    ++summary_.steps;
    note(resolved);
    if (is_last || stopping_ || state_.step % options_.every == 0) show(resolved, push);
  }

  /// A step that was cut short leaves no half-resolved positions behind.
  void undo_step() {
    state_.positions = state_.previous;
    --state_.step;
    state_.time -= options_.perturb_options.timestep;
    stopping_ = summary_.stopped_by_caller = true;
  }

  Push perturb() {
    const Stopwatch watch(summary_.perturb_seconds);
    const RandomKey key{options_.resolve.seed, Domain::force, options_.resolve.walker,
                        static_cast<std::uint64_t>(state_.step + 1), 0};
    const PerturbRequest request{framework_, options_.perturb_options, key};
    if (options_.replay.empty()) return perturbation_.push(request, state_);
    return apply_forces(request, {&options_.replay[std::size_t(summary_.steps)], 1}, state_);
  }

  ResolveSummary resolve(Joint root) {
    const Stopwatch watch(summary_.resolve_seconds);
    return resolver_.resolve(state_.positions, root, state_.step);
  }

  void note(const ResolveSummary& resolved) {
    summary_.sweeps += resolved.sweeps;
    summary_.projections += resolved.projections;
    summary_.max_sweeps = std::max(summary_.max_sweeps, resolved.sweeps);
    if (!resolved.converged()) {
      if (summary_.unconverged_steps++ == 0) summary_.first_unconverged_step = state_.step;
    }
    if (resolved.max_residual > summary_.worst_residual) {
      summary_.worst_residual = resolved.max_residual;
      summary_.worst_bar = resolved.worst_bar;
      summary_.worst_step = state_.step;
    }
  }

  void show(const ResolveSummary& resolved, const Push& push) {
    const Stopwatch watch(summary_.observe_seconds);
    const Frame frame{state_.step,           state_.time,
                      state_.positions,      resolved.sweeps,
                      resolved.projections,  resolved.max_residual,
                      resolved.rms_residual, resolved.stop,
                      push.root_joint,       push.force};
    for (const Observer& observer : observers_)
      if (observer(frame)) stopping_ = summary_.stopped_by_caller = true;
    ++summary_.frames;
  }

  const Framework& framework_;
  State& state_;
  const RunOptions& options_;
  const std::vector<Observer>& observers_;
  const PerturbationEntry& perturbation_;
  Resolver resolver_;
  RunSummary summary_;
  bool stopping_ = false;
};

}  // namespace

void check(const RunOptions& options) {
  check(options.technique);
  check(options.resolve);
  find_perturbation(options.perturb);
  check(options.perturb_options);
  if (options.steps < 0)
    throw OptionError("steps = " + std::to_string(options.steps) + ": must be from 0");
  if (options.every < 1)
    throw OptionError("every = " + std::to_string(options.every) + ": must be from 1");
}

RunSummary run(const Framework& framework, State& state, const RunOptions& options,
               const std::vector<Observer>& observers) {
  check(options);
  check_positions(framework, state.positions, options.resolve.tolerance, options.log);
  if (framework.joint_count() == 0) throw InputError("nothing to run: no joints");
  return Run(framework, state, options, observers).all();
}

}  // namespace pliant
