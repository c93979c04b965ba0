// SPDX-License-Identifier: MIT
#include "pliant/run/walk.hpp"

#include <algorithm>
#include <chrono>

#include "pliant/base/number.hpp"

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

}  // namespace

Walk::Walk(const Framework& framework, WalkerRun& walker, const RunOptions& options,
           Resolver& resolver)
    : framework_(framework),
      state_(walker.state),
      number_(walker.number),
      options_(options),
      observers_(walker.observers),
      on_push_(walker.on_push),
      log_(walker.log),
      perturbation_(find_perturbation(options.perturb)),
      resolver_(resolver),
      last_step_(walker.state.step + steps_to_do()) {}

std::int64_t Walk::steps_to_do() const {
  if (options_.replay.empty()) return options_.steps;
  return std::min(options_.steps, static_cast<std::int64_t>(options_.replay.size()));
}

void Walk::begin() {
  const Stopwatch watch(summary_.seconds);
  const ResidualSummary start = measured();
  is_whole_ = start.within;
  ResolveSummary resolved;
  resolved.stop = Stop::converged;
  resolved.sweeps = resolved.projections = 0;
  resolved.max_residual = start.max_relative;
  resolved.rms_residual = start.rms_relative;
  resolved.worst_bar = start.worst_bar;
  note_violations(start, resolved);
  if (!start.within) {
    log_.warn("the start misses its " + what_is_missed(start) + ": resolved first");
    resolved = resolve_all(0);
    is_whole_ = resolved.converged();
    summary_.resolve_seconds += resolved.seconds;
    state_.previous = state_.positions;
    note(resolved);
  }
  if (resolved.stop == Stop::stopped_by_caller) stopping_ = summary_.stopped_by_caller = true;
  show(resolved);
}

std::string Walk::what_is_missed(const ResidualSummary& start) const {
  const auto by = [](double length) { return " by " + number_text(length, 3) + " Angstrom"; };
  if (!is_whole(framework_, state_.positions, options_.resolve.tolerance))
    return "rest lengths, worst bar " + framework_.label(framework_.bars()[start.worst_bar]) +
           by(start.max_length);
  if (start.max_limit > options_.resolve.tolerance.limit) {
    const Limit& limit = framework_.limits()[start.worst_limit];
    return "limits, worst " + framework_.label(Bar{limit.a, limit.b}) + by(start.max_limit);
  }
  return "least distances, worst " + framework_.label(start.worst_overlap) + by(start.max_overlap);
}

void Walk::push() {
  const Stopwatch watch(summary_.seconds), own(summary_.perturb_seconds);
  time_before_ = state_.time;
  const RandomKey key{options_.resolve.seed, Domain::force, number_,
                      static_cast<std::uint64_t>(state_.step + 1), 0};
  PerturbRequest request{framework_, options_.perturb_options, key};
  if (knows_moved_) request.moved_before = moved_;
  push_ = options_.replay.empty()
              ? perturbation_.push(request, state_)
              : apply_forces(request, {&options_.replay[std::size_t(summary_.steps)], 1}, state_);
  ++state_.step;
  state_.time += options_.perturb_options.timestep;
  is_pushed_ = true;
}

Joint Walk::root() const {
  return push_.root_joint == no_joint ? 0 : static_cast<Joint>(push_.root_joint);
}

bool Walk::is_finite_after_push() const {
  if (push_.one_joint) return is_finite(state_.positions[root()]);
  return std::all_of(state_.positions.begin(), state_.positions.end(), is_finite);
}

std::optional<Joint> Walk::whole_resolve_from() const {
  if ((push_.one_joint && is_whole_) || !is_finite_after_push()) return std::nullopt;
  return root();
}

/// A push so hard that a position is no finite number is not resolved; finish() takes it back.
ResolveSummary Walk::resolve() {
  const Stopwatch watch(summary_.seconds);
  if (!is_finite_after_push()) {
    ResolveSummary resolved;
    resolved.stop = Stop::not_finite;
    resolved.sweeps = resolved.projections = 0;
    resolved.seconds = 0.0;
    return resolved;
  }
  // A push of one joint where all was whole leaves most of the framework as it was.
  return push_.one_joint && is_whole_ ? resolve_near(root()) : resolve_all(root());
}

ResolveSummary Walk::resolve_near(Joint root) {
  resolver_.set_walker(number_);
  resolver_.set_limits_off(state_.limits_off);
  const ResolveSummary resolved =
      resolver_.resolve_near(state_.positions, root, state_.step, state_.previous);
  const auto moved = resolver_.moved();
  knows_moved_ = moved.has_value();
  if (knows_moved_) {
    moved_.assign(moved->begin(), moved->end());
    moved_.push_back(root);
  }
  return resolved;
}

ResolveSummary Walk::resolve_all(Joint root) {
  resolver_.set_walker(number_);
  resolver_.set_limits_off(state_.limits_off);
  knows_moved_ = false;
  return resolver_.resolve(state_.positions, root, state_.step, state_.previous);
}

void Walk::take_back_push() {
  if (is_pushed_) undo_step();
  is_pushed_ = false;
}

void Walk::finish(ResolveSummary resolved) {
  const Stopwatch watch(summary_.seconds);
  is_pushed_ = false;
  summary_.resolve_seconds += resolved.seconds;
  if (resolved.stop == Stop::not_finite) {
    state_.positions = state_.previous;
    knows_moved_ = false;
    measure_all(resolved);
  } else {
    is_whole_ = resolved.converged();
  }
  if (resolved.stop == Stop::stopped_by_caller) return undo_step();
  ++summary_.steps;
  if (on_push_) on_push_(push_);
  summary_.sweeps += resolved.sweeps;
  summary_.max_sweeps = std::max(summary_.max_sweeps, resolved.sweeps);
  note(resolved);
  // Methods that are done in one pass do not ask under way.
  if (options_.resolve.should_stop && options_.resolve.should_stop())
    stopping_ = summary_.stopped_by_caller = true;
  if (shows_this_step()) show(resolved);
}

void Walk::finish_together(const ResolveSummary& resolved) {
  summary_.seconds += resolved.seconds;
  knows_moved_ = false;
  finish(resolved);
}

bool Walk::shows_this_step() const { return is_over() || state_.step % options_.every == 0; }

/// A step that was cut short leaves no half-resolved positions behind.
void Walk::undo_step() {
  state_.positions = state_.previous;
  --state_.step;
  state_.time = time_before_;
  stopping_ = summary_.stopped_by_caller = true;
}

ResidualSummary Walk::measured() const {
  return measure(framework_, state_.positions, options_.resolve.tolerance, state_.limits_off);
}

void Walk::measure_all(ResolveSummary& resolved) const {
  const ResidualSummary all = measured();
  resolved.max_residual = all.max_relative;
  resolved.rms_residual = all.rms_relative;
  resolved.worst_bar = all.worst_bar;
  note_violations(all, resolved);
}

void Walk::note(const ResolveSummary& resolved) {
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

void Walk::show(ResolveSummary resolved) {
  const Stopwatch watch(summary_.observe_seconds);
  if (resolved.rms_residual < 0.0) measure_all(resolved);
  const Frame frame{state_.step,           state_.time,
                    state_.positions,      resolved.sweeps,
                    resolved.projections,  resolved.max_residual,
                    resolved.rms_residual, resolved.stop,
                    push_.root_joint,      push_.force,
                    resolved.max_limit,    resolved.max_overlap};
  for (const Observer& observer : observers_)
    if (observer(frame)) stopping_ = summary_.stopped_by_caller = true;
  ++summary_.frames;
}

}  // namespace pliant
