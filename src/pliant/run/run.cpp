// SPDX-License-Identifier: MIT
#include "pliant/run/run.hpp"

#include <algorithm>
#include <chrono>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
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
    is_whole_ = start.within;
    ResolveSummary resolved;
    resolved.stop = Stop::converged;
    resolved.sweeps = resolved.projections = 0;
    resolved.max_residual = start.max_relative;
    resolved.rms_residual = start.rms_relative;
    resolved.worst_bar = start.worst_bar;
    if (!start.within) {
      options_.log.warn("the start misses its rest lengths, worst bar " +
                        framework_.label(framework_.bars()[start.worst_bar]) + " by " +
                        number_text(start.max_length, 3) + " Angstrom: resolved first");
      resolved = resolve(0);
      state_.previous = state_.positions;
      note(resolved);
    }
    if (resolved.stop == Stop::stopped_by_caller) stopping_ = summary_.stopped_by_caller = true;
    show(resolved, {});
  }

  void step(bool is_last) {
    const double time_before = state_.time;
    const Push push = perturb();
    ++state_.step;
    state_.time += options_.perturb_options.timestep;
    const ResolveSummary resolved = resolve_push(push);
    if (resolved.stop == Stop::stopped_by_caller) return undo_step(time_before);
    ++summary_.steps;
    if (options_.on_push) options_.on_push(push);
    summary_.sweeps += resolved.sweeps;
    summary_.max_sweeps = std::max(summary_.max_sweeps, resolved.sweeps);
    note(resolved);
    // Methods that are done in one pass do not ask under way.
    if (options_.resolve.should_stop && options_.resolve.should_stop())
      stopping_ = summary_.stopped_by_caller = true;
    if (is_last || stopping_ || state_.step % options_.every == 0) show(resolved, push);
  }

  /// A step that was cut short leaves no half-resolved positions behind.
  void undo_step(double time_before) {
    state_.positions = state_.previous;
    --state_.step;
    state_.time = time_before;
    stopping_ = summary_.stopped_by_caller = true;
  }

  Push perturb() {
    const Stopwatch watch(summary_.perturb_seconds);
    const RandomKey key{options_.resolve.seed, Domain::force, options_.resolve.walker,
                        static_cast<std::uint64_t>(state_.step + 1), 0};
    PerturbRequest request{framework_, options_.perturb_options, key};
    if (knows_moved_) request.moved_before = moved_;
    if (options_.replay.empty()) return perturbation_.push(request, state_);
    return apply_forces(request, {&options_.replay[std::size_t(summary_.steps)], 1}, state_);
  }

  /// A push so hard that a position or a length is no finite number is taken back.
  ResolveSummary resolve_push(const Push& push) {
    ResolveSummary resolved;
    resolved.stop = Stop::not_finite;
    resolved.sweeps = resolved.projections = 0;
    if (is_finite_after(push)) resolved = resolve_from(push);
    if (resolved.stop != Stop::not_finite) return resolved;
    state_.positions = state_.previous;
    knows_moved_ = false;
    measure_all(resolved);
    return resolved;
  }

  void measure_all(ResolveSummary& resolved) const {
    const ResidualSummary all = measure(framework_, state_.positions, options_.resolve.tolerance);
    resolved.max_residual = all.max_relative;
    resolved.rms_residual = all.rms_relative;
    resolved.worst_bar = all.worst_bar;
  }

  bool is_finite_after(const Push& push) const {
    if (push.one_joint) return is_finite(state_.positions[std::size_t(push.root_joint)]);
    return std::all_of(state_.positions.begin(), state_.positions.end(), is_finite);
  }

  /// A push of one joint where all was whole leaves most of the framework as it was.
  ResolveSummary resolve_from(const Push& push) {
    const Joint root = push.root_joint == no_joint ? 0 : static_cast<Joint>(push.root_joint);
    if (!push.one_joint || !is_whole_) return resolve(root);
    const Stopwatch watch(summary_.resolve_seconds);
    const ResolveSummary resolved =
        resolver_.resolve_near(state_.positions, root, state_.step, state_.previous);
    const auto moved = resolver_.moved();
    knows_moved_ = moved.has_value();
    if (knows_moved_) {
      moved_.assign(moved->begin(), moved->end());
      moved_.push_back(root);
    }
    is_whole_ = resolved.converged();
    return resolved;
  }

  ResolveSummary resolve(Joint root) {
    const Stopwatch watch(summary_.resolve_seconds);
    const ResolveSummary resolved =
        resolver_.resolve(state_.positions, root, state_.step, state_.previous);
    knows_moved_ = false;
    is_whole_ = resolved.converged();
    return resolved;
  }

  void note(const ResolveSummary& resolved) {
    summary_.projections += resolved.projections;
    if (!resolved.converged()) {
      if (summary_.unconverged_steps++ == 0) summary_.first_unconverged_step = state_.step;
    }
    if (resolved.max_residual > summary_.worst_residual) {
      summary_.worst_residual = resolved.max_residual;
      summary_.worst_bar = resolved.worst_bar;
      summary_.worst_step = state_.step;
    }
  }

  void show(ResolveSummary resolved, const Push& push) {
    const Stopwatch watch(summary_.observe_seconds);
    if (resolved.rms_residual < 0.0) measure_all(resolved);
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
  bool is_whole_ = false;     ///< all bars, before the push
  bool knows_moved_ = false;  ///< no joint but those of moved_ has left its previous position
  std::vector<Joint> moved_;
};

}  // namespace

namespace {

void check_replay(const Framework& framework, const RunOptions& options) {
  for (const JointForce& push : options.replay) {
    if (push.joint >= framework.joint_count())
      throw OptionError("replay: joint " + std::to_string(push.joint) + " of " +
                        std::to_string(framework.joint_count()) + " does not exist");
    if (!is_finite(push.force))
      throw OptionError("replay: the force on " + framework.label(push.joint) + " is not finite");
  }
}

void check_previous(const Framework& framework, const State& state) {
  if (state.previous.size() != framework.joint_count())
    throw InputError("framework: " + std::to_string(framework.joint_count()) + " joints but " +
                     std::to_string(state.previous.size()) + " previous positions");
  for (std::size_t i = 0; i < state.previous.size(); ++i)
    if (!is_finite(state.previous[i]))
      throw InputError("previous position of " + framework.label(static_cast<Joint>(i)) +
                       " is not finite");
}

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
  check_previous(framework, state);
  check_replay(framework, options);
  if (framework.joint_count() == 0) throw InputError("nothing to run: no joints");
  return Run(framework, state, options, observers).all();
}

}  // namespace pliant
