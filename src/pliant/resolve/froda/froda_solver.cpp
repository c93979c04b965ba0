// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/froda_solver.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Angstrom
constexpr double pull_bound = 1.5;
constexpr double last_bound = 0.5;
constexpr double margin = 0.01;  // steps aim inside limits, so that they end there
constexpr double widest_closed = 1e-12;
constexpr double largest_closing = 0.3;  // of a joint: more is no rounding off, but another place

constexpr double pull_weight = 10.0;
constexpr double last_weight = 100.0;
constexpr double spring_weight = 60.0;  // Angstrom^2: of torsion preferences
constexpr int last_pulls = 3;           // blind, then as many with contacts
constexpr int careful_pulls = 5;
constexpr int most_closings = 12;
/// A step gains if it takes more than a twentieth off. Without gain for so many steps it is over;
/// where something is still too near, later.
constexpr double least_gain = 0.95;
constexpr int patience = 6, long_patience = 15;
constexpr double tiny = 1e-9;

/// The interval that a step aims at.
struct Aim {
  double least, most;
};

Aim aim_of(const Limit& limit) {
  const double least = limit.least > 0.0 ? limit.least + margin : 0.0;
  const double most = limit.most - margin;
  return least <= most ? Aim{least, most} : Aim{limit.least, limit.most};
}

}  // namespace

FrodaSolver::FrodaSolver(const Framework& framework, const BodyPlan& plan, double unit)
    : framework_(framework),
      plan_(plan),
      unit_(unit),
      step_(plan, unit),
      springs_(framework, plan) {
  if (framework.sterics() != nullptr) pairs_ = std::make_unique<NearPairs>(framework, plan);
}

FrodaOutcome FrodaSolver::resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                                  std::span<Vec3> out, const FrodaOptions& options,
                                  LimitsOff limits_off) {
  limits_off_ = limits_off;
  steps_ = 0;
  begin(start, target);
  pull(options);
  FrodaOutcome outcome;
  outcome.is_whole = push_apart(options, outcome);
  outcome.steps = steps_;
  for (Joint joint = 0; joint < out.size(); ++joint)
    out[joint] = x_[plan_.place_of(joint)] + origin_;
  return outcome;
}

void FrodaSolver::begin(std::span<const Vec3> start, std::span<const Vec3> target) {
  origin_ = {};
  for (Vec3 x : start) origin_ += (1.0 / double(start.size())) * x;
  const auto joint_at = plan_.joint_at();
  start_.resize(joint_at.size());
  push_.resize(joint_at.size());
  for (std::size_t k = 0; k < joint_at.size(); ++k) {
    start_[k] = start[joint_at[k]] - origin_;
    push_[k] = target[joint_at[k]] - start[joint_at[k]];
  }
  x_ = start_;
  target_.resize(x_.size());
}

/// Towards targets on the way, at most a leg apart.
void FrodaSolver::pull(const FrodaOptions& options) {
  double furthest = 0.0;
  for (Vec3 push : push_) furthest = std::max(furthest, norm_squared(push));
  const int legs =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(furthest) / (options.leg * unit_))));
  for (int leg = 1; leg < legs; ++leg) pull_to(double(leg) / legs, 1, options.is_careful, options);
  if (options.is_careful) return pull_to(1.0, careful_pulls, true, options);
  pull_to(1.0, last_pulls, false, options);
  find_rows(pull_weight);
  if (!rows_.empty()) pull_to(1.0, last_pulls, true, options);
}

void FrodaSolver::pull_to(double share, int steps, bool sees_contacts,
                          const FrodaOptions& options) {
  for (std::size_t k = 0; k < x_.size(); ++k) target_[k] = start_[k] + share * push_[k];
  for (int k = 0; k < steps; ++k) {
    rows_.clear();
    if (sees_contacts) find_rows(pull_weight);
    step(target_, pull_bound, options.is_careful ? options.conjugate_gradients : 0, sees_contacts);
  }
}

/// Contacts alone, until all hold or nothing is gained any more.
bool FrodaSolver::push_apart(const FrodaOptions& options, FrodaOutcome& outcome) {
  double least = HUGE_VAL;
  int since = 0;
  for (int k = 0;; ++k) {
    const Violation worst = find_rows(last_weight);
    const double here = std::max(worst.limit, worst.overlap);
    if (here <= options.goal || k >= options.last_steps) break;
    since = here < least_gain * least ? 0 : since + 1;
    least = std::min(least, here);
    if (since >= (least <= std::min(options.limit, options.overlap) ? patience : long_patience))
      break;
    step({}, last_bound, options.is_careful ? options.conjugate_gradients : 0, true);
  }
  return finish(options, outcome);
}

bool FrodaSolver::finish(const FrodaOptions& options, FrodaOutcome& outcome) {
  outcome.max_closing = close_loops();
  const Violation worst = find_rows(last_weight);
  outcome.max_limit = worst.limit;
  outcome.max_overlap = worst.overlap;
  return worst.limit <= options.limit && worst.overlap <= options.overlap &&
         widest_gap() <= 10.0 * widest_closed * unit_ &&
         outcome.max_closing <= largest_closing * unit_;
}

/// Closes the loops that were cut; how far a joint went (Angstrom).
double FrodaSolver::close_loops() {
  if (plan_.cuts().empty()) return 0.0;
  before_ = x_;
  rows_.clear();
  for (int k = 0; k < most_closings && widest_gap() > widest_closed * unit_; ++k)
    step({}, last_bound, 0, false);
  double furthest = 0.0;
  for (std::size_t k = 0; k < x_.size(); ++k)
    furthest = std::max(furthest, norm_squared(x_[k] - before_[k]));
  return std::sqrt(furthest);
}

double FrodaSolver::widest_gap() const {
  double widest = 0.0;
  for (const LoopCut& cut : plan_.cuts())
    widest = std::max(widest, distance(x_[cut.copy], x_[cut.joint]));
  return widest;
}

FrodaSolver::Violation FrodaSolver::find_rows(double weight) {
  rows_.clear();
  Violation worst;
  find_limit_rows(weight, worst);
  if (pairs_) find_steric_rows(weight, worst);
  return worst;
}

void FrodaSolver::find_limit_rows(double weight, Violation& worst) {
  const auto limits = framework_.limits();
  for (LimitIndex k = 0; k < limits.size(); ++k) {
    if (is_off(limits_off_, k)) continue;
    const Slot i = plan_.place_of(limits[k].a), j = plan_.place_of(limits[k].b);
    const Aim aim = aim_of(limits[k]);
    const Vec3 apart = x_[i] - x_[j];
    const double square = norm_squared(apart);
    if (square <= aim.most * aim.most && square >= aim.least * aim.least) continue;
    const double length = std::sqrt(square);
    worst.limit = std::max(worst.limit, std::abs(excess(limits[k], length)));
    const double gap = (length > aim.most ? aim.most : aim.least) - length;
    rows_.push_back({i, j, (1.0 / (length + tiny)) * apart, gap, weight});
  }
}

void FrodaSolver::find_steric_rows(double weight, Violation& worst) {
  pairs_->update(x_);
  for (const NearPair& pair : pairs_->pairs()) {
    const double aim = pair.least + margin;
    const Vec3 apart = x_[pair.i] - x_[pair.j];
    const double square = norm_squared(apart);
    if (square >= aim * aim) continue;
    const double length = std::sqrt(square);
    worst.overlap = std::max(worst.overlap, pair.least - length);
    rows_.push_back({pair.i, pair.j, (1.0 / (length + tiny)) * apart, aim - length, weight});
  }
}

void FrodaSolver::step(std::span<const Vec3> targets, double bound, int conjugate_gradients,
                       bool has_springs) {
  std::span<const TurnSpring> springs;
  if (has_springs && !springs_.empty()) springs = springs_.at(x_, spring_weight);
  step_.step(x_, {targets, rows_, springs, bound * unit_, conjugate_gradients});
  ++steps_;
}

}  // namespace pliant
