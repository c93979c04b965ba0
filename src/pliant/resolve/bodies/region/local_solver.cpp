// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/local_solver.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/resolve/bodies/pull/contact_steps.hpp"

namespace pliant {

using froda::last_pulls, froda::pull_weight;

namespace {

// Angstrom
constexpr double longest_leg = 1.0;       // largest distance between targets
constexpr double farthest_of_step = 1.5;  // largest displacement of a body in a step
constexpr double widest_left = 1e-13;
constexpr double small_push = 0.1;

/// Rounding adds up to some 1e-16 Angstrom a step.
constexpr std::uint64_t steps_a_restore = 8;
constexpr double most_local_legs = 1e3;
/// Pulls end when one moves no body further than this share of the push.
constexpr double settled_of_push = 0.05;
constexpr int most_repairs = 30, most_closing_steps = 12;
/// A step of Newton's method that leaves a larger share of the gaps does not converge.
constexpr double least_closed = 0.2;
/// A region whose joints go further than this many times the push is not near.
constexpr double most_near = 4.0;

}  // namespace

LocalSolver::LocalSolver(const Framework& framework, const Tolerance& tolerance,
                         const LocalOptions& options)
    : planner_(framework),
      shapes_(framework),
      plan_(&planner_.plan({}, 0)),
      working_(*plan_),
      step_(*plan_, working_, options.unit),
      contacts_(framework, *plan_),
      tolerance_(tolerance),
      options_(options),
      has_contacts_(!framework.has_bars_only()) {
  options_.goal = std::min({options.goal, tolerance.limit, tolerance.overlap});
}

LocalResult LocalSolver::resolve(const LocalPush& push, std::size_t most_bodies) {
  begin(push, most_bodies);
  pull();
  if (has_contacts_) repair();
  LocalResult result;
  result.is_whole = close() && is_near();
  if (has_contacts_ && result.is_whole) {
    const ContactViolation left = contacts_.find(x_, froda::last_weight);
    result.is_whole = left.limit <= tolerance_.limit && left.overlap <= tolerance_.overlap;
  }
  result.followed = followed();
  result.visits = visits_;
  return result;
}

void LocalSolver::begin(const LocalPush& push, std::size_t most_bodies) {
  planner_.plan(push.joints, most_bodies);
  working_.fit();
  step_.fit();
  visits_ = 0;
  origin_ = push.start[push.joints[0]];
  const auto joint_at = plan_->joint_at();
  start_.resize(joint_at.size());
  push_.resize(joint_at.size());
  for (std::size_t k = 0; k < joint_at.size(); ++k) {
    start_[k] = push.start[joint_at[k]] - origin_;
    push_[k] = push.target[joint_at[k]] - push.start[joint_at[k]];
  }
  x_ = start_;
  if (push.step % steps_a_restore == 0) shapes_.restore(planner_.units(), joint_at, start_, x_);
  target_.resize(x_.size());
  pulls_.clear();
  double square = 0.0;
  for (Joint joint : push.joints) {
    pulls_.push_back({plan_->place_of(joint), {}, options_.weight - 1.0});
    square = std::max(square, norm_squared(push_[pulls_.back().at]));
  }
  way_ = std::sqrt(square);
  legs_ = int(std::clamp(std::ceil(way_ / (longest_leg * options_.unit)), 1.0, most_local_legs));
  if (has_contacts_) contacts_.begin(push.start, origin_, push.limits_off, push.neighbours);
}

void LocalSolver::set_targets(double share) {
  for (std::size_t at = 0; at < x_.size(); ++at) target_[at] = start_[at] + share * push_[at];
  for (PlacePull& pull : pulls_) pull.way = target_[pull.at] - x_[pull.at];
}

void LocalSolver::pull() {
  const double first = pull_blindly();
  if (!has_contacts_ || first <= froda::small_move * options_.unit) return;
  for (int k = 0; k < last_pulls; ++k) {
    set_targets(1.0);
    contacts_.find(x_, pull_weight);
    step({target_, contacts_.rows(), {}, farthest_of_step * options_.unit, 0, pulls_});
  }
}

/// Returns how far the first step moved a body (Angstrom). One step goes far enough with a small
/// push: what a second would add is of second order.
double LocalSolver::pull_blindly() {
  double first = 0.0;
  const int pulls = way_ <= small_push * options_.unit ? 1 : legs_ + last_pulls - 1;
  for (int k = 1; k <= pulls; ++k) {
    const double share = std::min(1.0, double(k) / legs_);
    set_targets(share);
    const double moved = step({target_, {}, {}, farthest_of_step * options_.unit, 0, pulls_});
    if (k == 1) first = moved;
    if (moved <= settled_of_push * way_ && share == 1.0) break;
  }
  return first;
}

/// Steps for contacts alone.
void LocalSolver::repair() {
  double least = HUGE_VAL;
  int since_gain = 0;
  for (int k = 0; k < most_repairs; ++k) {
    const double here = contacts_.find(x_, froda::last_weight).worst();
    since_gain = here < froda::least_gain * least ? 0 : since_gain + 1;
    least = std::min(least, here);
    if (here <= options_.goal || since_gain >= froda::patience) return;
    step({{}, contacts_.rows(), {}, froda::last_bound * options_.unit, 0, {}});
  }
}

/// Closes the loops over the ground by Newton's method. Where a region is all stretched out, that
/// hardly converges: then it is given up at once.
bool LocalSolver::close() {
  double gap = plan_->widest_gap(x_);
  for (int k = 0; k < most_closing_steps && gap > widest_left * options_.unit; ++k) {
    step({{}, {}, {}, froda::last_bound * options_.unit, 0, {}});
    const double before = gap;
    gap = plan_->widest_gap(x_);
    if (!(gap <= least_closed * before) && gap > 10.0 * widest_left * options_.unit) return false;
  }
  return gap <= 10.0 * widest_left * options_.unit;
}

double LocalSolver::step(const StepRequest& request) {
  visits_ += static_cast<std::int64_t>(plan_->bodies().size());
  return step_.step(x_, request);
}

double LocalSolver::followed() const {
  double along = 0.0, squares = 0.0;
  for (const PlacePull& pull : pulls_) {
    along += dot(x_[pull.at] - start_[pull.at], push_[pull.at]);
    squares += norm_squared(push_[pull.at]);
  }
  return squares > 0.0 ? along / squares : 1.0;
}

bool LocalSolver::is_near() const {
  double furthest = 0.0;
  for (std::size_t at = 0; at < x_.size(); ++at)
    furthest = std::max(furthest, norm_squared(x_[at] - start_[at] - push_[at]));
  return furthest <= most_near * most_near * way_ * way_;
}

}  // namespace pliant
