// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/froda_solver.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Angstrom
constexpr double pull_bound = 1.5;
/// A first step that moves no body further has carried nothing through anything: contacts alone
/// then mend what it broke.
constexpr double small_move = 0.1;
constexpr double last_bound = 0.5;
constexpr double margin = 0.01;  // steps aim inside limits, so that they end there
constexpr double widest_closed = 1e-12;
constexpr double largest_closing = 0.3;  // of a joint: more is no rounding off, but another place

constexpr double pull_weight = 10.0;
constexpr double last_weight = 100.0;
constexpr double spring_weight = 60.0;  // Angstrom^2: of torsion preferences
constexpr int last_pulls = 3;           // blind, then as many with contacts
/// Blind pulls of a small push end when one goes no further than this share of the first.
constexpr double settled_share = 0.5;
constexpr double most_legs = 1e4;  // however far the push
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
      working_(plan),
      step_(plan, working_, unit),
      springs_(framework, plan) {
  if (framework.sterics() != nullptr) pairs_ = std::make_unique<NearPairs>(framework, plan);
}

FrodaOutcome FrodaSolver::resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                                  std::span<Vec3> out, const FrodaOptions& options,
                                  LimitsOff limits_off) {
  limits_off_ = limits_off;
  goal_ = options.goal;
  steps_ = 0;
  visits_ = 0;
  is_looked_at_ = false;
  begin(start, target, options.is_careful);
  pull(options);
  FrodaOutcome outcome;
  outcome.is_whole = push_apart(options, outcome);
  outcome.steps = steps_;
  outcome.visits = visits_;
  for (Joint joint = 0; joint < out.size(); ++joint)
    out[joint] = x_[plan_.place_of(joint)] + origin_;
  return outcome;
}

void FrodaSolver::begin(std::span<const Vec3> start, std::span<const Vec3> target,
                        bool is_careful) {
  origin_ = {};
  for (Vec3 x : start) origin_ += (1.0 / double(start.size())) * x;
  const auto joint_at = plan_.joint_at();
  start_.resize(joint_at.size());
  push_.resize(joint_at.size());
  working_.clear();
  if (is_careful) working_.add_all();  // conjugate gradients go over all
  for (std::size_t k = 0; k < joint_at.size(); ++k) {
    start_[k] = start[joint_at[k]] - origin_;
    push_[k] = target[joint_at[k]] - start[joint_at[k]];
    // Trees that the push moves; contacts add others.
    if (norm_squared(push_[k]) != 0.0) working_.add(plan_.tree_of(plan_.body_at()[k]));
  }
  x_ = start_;
  target_.resize(x_.size());
}

/// Towards targets on the way, at most a leg apart.
void FrodaSolver::pull(const FrodaOptions& options) {
  double furthest = 0.0;
  for (Vec3 push : push_) furthest = std::max(furthest, norm_squared(push));
  const double wanted = std::ceil(std::sqrt(furthest) / (options.leg * unit_));
  const int legs = static_cast<int>(std::clamp(wanted, 1.0, most_legs));
  for (int leg = 1; leg < legs; ++leg) pull_to(double(leg) / legs, 1, options.is_careful, options);
  if (options.is_careful) {
    pull_to(1.0, careful_pulls, true, options);
    return;
  }
  if (pull_blindly(options) && legs == 1) return;
  find_rows(pull_weight);
  if (!rows_.empty()) pull_to(1.0, last_pulls, true, options);
}

/// All blind pulls. True if the push is so small that contacts need none of their own.
bool FrodaSolver::pull_blindly(const FrodaOptions& options) {
  const double first = pull_to(1.0, 1, false, options);
  const bool is_small = first <= small_move * unit_;
  double moved = first;
  for (int k = 1; k < last_pulls && !(is_small && moved <= settled_share * first); ++k)
    moved = pull_to(1.0, 1, false, options);
  return is_small;
}

/// How far the last of the steps moved the body that went furthest (Angstrom).
double FrodaSolver::pull_to(double share, int steps, bool sees_contacts,
                            const FrodaOptions& options) {
  double moved = 0.0;
  std::size_t bodies = 0;  // that have targets
  for (int k = 0; k < steps; ++k) {
    is_looked_at_ = false;
    rows_.clear();
    if (sees_contacts) find_rows(pull_weight);
    bodies = set_targets(share, bodies);
    moved = step(target_, pull_bound, options.is_careful ? options.conjugate_gradients : 0,
                 sees_contacts && options.has_torsion_preferences);
  }
  return moved;
}

/// Of working bodies from the `first` on, to which contacts add some; how many there are now.
std::size_t FrodaSolver::set_targets(double share, std::size_t first) {
  const auto working = working_.bodies();
  for (const std::uint32_t body : working.subspan(first))
    for (Slot at = plan_.bodies()[body].first; at < plan_.bodies()[body].last; ++at)
      target_[at] = start_[at] + share * push_[at];
  return working.size();
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
    step({}, last_bound, options.is_careful ? options.conjugate_gradients : 0,
         options.has_torsion_preferences);
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
  if (widest_gap() <= widest_closed * unit_) return 0.0;
  before_ = x_;
  is_looked_at_ = false;
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
  if (is_looked_at_) {
    for (ContactRow& row : rows_) row.weight = weight;
    return worst_;
  }
  rows_.clear();
  worst_ = {};
  find_limit_rows(weight, worst_);
  if (pairs_) find_steric_rows(weight, worst_);
  is_looked_at_ = true;
  return worst_;
}

/// Steps aim a little inside limits. Where nothing moves, a contact that holds is left as it is.
void FrodaSolver::add_row(const ContactRow& row, double broken) {
  const std::uint32_t one = plan_.tree_of(plan_.body_at()[row.i]);
  const std::uint32_t other = plan_.tree_of(plan_.body_at()[row.j]);
  if (!(broken > goal_) && !working_.holds(one) && !working_.holds(other)) return;
  rows_.push_back(row);
  working_.add(one);
  working_.add(other);
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
    const double broken = std::abs(excess(limits[k], length));
    worst.limit = std::max(worst.limit, broken);
    const double gap = (length > aim.most ? aim.most : aim.least) - length;
    add_row({i, j, (1.0 / (length + tiny)) * apart, gap, weight}, broken);
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
    const double broken = pair.least - length;
    worst.overlap = std::max(worst.overlap, broken);
    add_row({pair.i, pair.j, (1.0 / (length + tiny)) * apart, aim - length, weight}, broken);
  }
}

double FrodaSolver::step(std::span<const Vec3> targets, double bound, int conjugate_gradients,
                         bool has_springs) {
  std::span<const TurnSpring> springs;
  if (has_springs && !springs_.empty()) springs = springs_.at(x_, spring_weight);
  ++steps_;
  visits_ += static_cast<std::int64_t>(working_.bodies().size());
  is_looked_at_ = false;
  return step_.step(x_, {targets, rows_, springs, bound * unit_, conjugate_gradients});
}

}  // namespace pliant
