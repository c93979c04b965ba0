// SPDX-License-Identifier: MIT
#include "pliant/run/walk.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/framework/measures/check_positions.hpp"
#include "pliant/perturb/pushers.hpp"
#include "pliant/run/stopwatch.hpp"

namespace pliant {
namespace {

void check_previous(const Framework& framework, const State& state) {
  if (state.previous.size() != framework.joint_count())
    throw InputError("framework: " + std::to_string(framework.joint_count()) + " joints but " +
                     std::to_string(state.previous.size()) + " previous positions");
  for (std::size_t i = 0; i < state.previous.size(); ++i)
    if (!is_finite(state.previous[i]))
      throw InputError("previous position of " + framework.label(static_cast<Joint>(i)) +
                       " is not finite");
}

ResolveSummary nothing_done(Stop stop) {
  ResolveSummary resolved;
  resolved.stop = stop;
  resolved.sweeps = resolved.projections = 0;
  resolved.seconds = 0.0;
  return resolved;
}

}  // namespace

Walk::Walk(const Framework& framework, State& state, const MotionOptions& options,
           std::uint64_t walker)
    : framework_(framework),
      state_(state),
      number_(walker),
      resolve_(options.resolve),
      log_(options.log),
      pushers_(framework, options.perturb, {options.resolve.seed, Domain::force, walker}),
      last_(nothing_done(Stop::converged)) {
  check_positions(framework, state.positions, resolve_.tolerance, log_);
  check_previous(framework, state);
  const PusherOptions made_with{options.perturb, options.replay, options.replay_from, options.guide,
                                options.replay_counts};
  for (const std::string& name : options.push)
    pushers_.add(find_pusher(name).make(framework, made_with));
  if (framework.joint_count() == 0) throw InputError("nothing to run: no joints");
}

void Walk::start(Resolver& resolver) {
  const Stopwatch watch(summary_.seconds);
  const ResidualSummary start = measured();
  is_whole_ = start.within;
  last_ = nothing_done(Stop::converged);
  last_.max_residual = start.max_relative;
  last_.rms_residual = start.rms_relative;
  last_.worst_bar = start.worst_bar;
  note_violations(start, last_);
  if (start.within) return;
  log_.warn("the start misses its " + what_is_missed(start) + ": resolved first");
  resolver.set_walker(number_);
  resolver.set_limits_off(state_.limits_off);
  last_ = resolver.resolve(state_.positions, 0, 0, state_.previous);
  pushers_.past().forget();
  is_whole_ = last_.converged();
  summary_.resolve_seconds += last_.seconds;
  state_.previous = state_.positions;
  note(last_);
  if (last_.stop == Stop::stopped_by_caller) stop();
}

void Walk::push() {
  const Stopwatch watch(summary_.seconds), own(summary_.perturb_seconds);
  is_stopped_ = false;
  if (!is_whole_) is_whole_ = measured().within;
  pushers_.push(state_);
  is_pushed_ = true;
}

Disturbed Walk::disturbed() const {
  Disturbed disturbed = pushed().disturbed();
  if (!*is_whole_) disturbed.all = true;
  disturbed.continues = continues_;
  return disturbed;
}

bool Walk::is_finite_after_push() const {
  const std::vector<Vec3>& x = state_.positions;
  if (pushed().all) return std::all_of(x.begin(), x.end(), is_finite);
  return std::all_of(pushed().joints.begin(), pushed().joints.end(),
                     [&](Joint joint) { return is_finite(x[joint]); });
}

/// A push so hard that a position is no finite number is not resolved; finish() takes it back.
ResolveSummary Walk::resolve(Resolver& resolver) {
  if (!is_finite_after_push()) return nothing_done(Stop::not_finite);
  return resolve_disturbed(resolver, disturbed());
}

ResolveSummary Walk::resolve_disturbed(Resolver& resolver, const Disturbed& disturbed) {
  if (!disturbed.all && disturbed.joints.empty()) {
    pushers_.past().only_moved({}, {});
    return nothing_done(Stop::converged);
  }
  resolver.set_walker(number_);
  resolver.set_limits_off(state_.limits_off);
  continues_ = false;  // where it throws
  const ResolveSummary resolved =
      resolver.resolve(state_.positions, disturbed, state_.step, state_.previous);
  continues_ = resolved.converged();
  if (!disturbed.all)
    if (const auto moved = resolver.moved()) pushers_.past().only_moved(*moved, disturbed.joints);
  return resolved;
}

void Walk::take_back_push() {
  if (is_pushed_) pushers_.take_back(state_);
  is_pushed_ = false;
}

bool Walk::finish(ResolveSummary resolved) {
  summary_.resolve_seconds += resolved.seconds;
  summary_.seconds += resolved.seconds;
  const Stopwatch watch(summary_.seconds);
  last_ = resolved_ = resolved;
  if (resolved.stop == Stop::stopped_by_caller) {
    take_back_push();  // no half-resolved positions are left behind
    stop();
    last_.max_residual = last_.rms_residual = -1.0;
    return false;
  }
  is_pushed_ = false;
  if (resolved.stop == Stop::not_finite) {
    state_.positions = state_.previous;
    pushers_.past().only_moved({}, {});
    measure_all(last_);
  } else {
    is_whole_ = resolved.converged();
  }
  ++summary_.steps;
  summary_.sweeps += last_.sweeps;
  summary_.max_sweeps = std::max(summary_.max_sweeps, last_.sweeps);
  note(last_);
  // Methods that are done in one pass do not ask under way.
  if (resolve_.should_stop && resolve_.should_stop()) stop();
  return true;
}

State& Walk::change_state() {
  pushers_.past().forget();
  continues_ = false;
  is_whole_.reset();
  return state_;
}

ResidualSummary Walk::measured() const {
  return measure(framework_, state_.positions, resolve_.tolerance, state_.limits_off);
}

std::string Walk::what_is_missed(const ResidualSummary& start) const {
  const auto by = [](double length) { return " by " + number_text(length, 3) + " Angstrom"; };
  if (!is_whole(framework_, state_.positions, resolve_.tolerance))
    return "rest lengths, worst bar " + framework_.label(framework_.bars()[start.worst_bar]) +
           by(start.max_length);
  if (start.max_limit > resolve_.tolerance.limit) {
    const Limit& limit = framework_.limits()[start.worst_limit];
    return "limits, worst " + framework_.label(Bar{limit.a, limit.b}) + by(start.max_limit);
  }
  return "least distances, worst " + framework_.label(start.worst_overlap) + by(start.max_overlap);
}

/// Frames are measured again and again, mostly after few joints have moved.
void Walk::measure_all(ResolveSummary& resolved) {
  if (!framework_.has_bars_only() && !kept_)
    kept_ = std::make_unique<KeptMeasure>(framework_, resolve_.tolerance);
  const ResidualSummary all =
      kept_ ? kept_->measure(state_.positions, state_.limits_off) : measured();
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
    if (framework_.bar_count() > 0) summary_.worst_joints = framework_.bars()[resolved.worst_bar];
    summary_.worst_step = state_.step;
  }
}

Frame Walk::frame() {
  const Stopwatch watch(summary_.seconds), own(summary_.observe_seconds);
  if (last_.rms_residual < 0.0) measure_all(last_);
  ++summary_.frames;
  return {state_.step,         state_.time,        state_.positions,   last_.sweeps,
          last_.projections,   last_.max_residual, last_.rms_residual, last_.stop,
          pushed().root_joint, pushed().force,     last_.max_limit,    last_.max_overlap,
          state_.previous,     state_.limits_off};
}

}  // namespace pliant
