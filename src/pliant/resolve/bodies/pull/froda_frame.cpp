// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/froda_frame.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/resolve/bodies/pull/contact_steps.hpp"

namespace pliant {
namespace {

// Angstrom
constexpr double widest_closed = 1e-12;
constexpr double largest_closing = 0.3;  // of a joint: more is no rounding off, but another place

/// Careful pulls to the last target weigh contacts twice as much each time: the first one reaches
/// the target blindly, the last ones leave few contacts to steps for contacts alone.
constexpr double weight_growth = 2.0;
constexpr double spring_weight = 60.0;  // Angstrom^2: of torsion preferences
constexpr double most_legs = 1e4;       // however far the push
constexpr int careful_pulls = 4;
constexpr int most_closings = 12;
/// After so many steps without gain torsion preferences let go: contacts win against them.
constexpr int patience_with_springs = 2;

}  // namespace

FrodaFrame::FrodaFrame(const Framework& framework, const BodyPlan& plan, double unit)
    : framework_(framework),
      plan_(plan),
      unit_(unit),
      working_(plan),
      springs_(framework, plan),
      pairs_(framework.sterics() == nullptr ? nullptr
                                            : std::make_unique<NearPairs>(framework, plan)) {}

void FrodaFrame::begin(const FrodaPush& push, const FrodaOptions& options) {
  const auto [start, target, limits_off, course] = push;
  options_ = options;
  limits_off_ = limits_off;
  course_ = course;
  steps_ = pulls_ = pushes_ = closings_ = since_gain_ = 0;
  visits_ = 0;
  least_ = HUGE_VAL;
  springs_let_go_ = false;
  is_looked_at_ = false;
  target_share_ = 0.0;
  bodies_with_targets_ = 0;
  rows_.clear();
  origin_ = {};
  for (Vec3 x : start) origin_ += (1.0 / double(start.size())) * x;
  const auto joint_at = plan_.joint_at();
  start_.resize(joint_at.size());
  push_.resize(joint_at.size());
  working_.clear();
  if (options.is_careful) working_.add_all();  // conjugate gradients go over all
  double furthest = 0.0;
  for (std::size_t k = 0; k < joint_at.size(); ++k) {
    start_[k] = start[joint_at[k]] - origin_;
    push_[k] = target[joint_at[k]] - start[joint_at[k]];
    const double square = norm_squared(push_[k]);
    furthest = std::max(furthest, square);
    // Trees that the push moves; contacts add others.
    if (square != 0.0) working_.add(plan_.tree_of(plan_.body_at()[k]));
  }
  x_ = start_;
  target_.resize(x_.size());
  double way = std::sqrt(furthest);
  if (course != nullptr) {
    way = course->length;
    options_.leg = course->leg;
    options_.bound = course->bound;
    options_.legs_a_look = 1;  // pieces turn past each other
  }
  const double wanted = std::ceil(way / (options_.leg * unit_));
  legs_ = static_cast<int>(std::clamp(wanted, 1.0, most_legs));
}

bool FrodaFrame::ask_for_careful_pull() {
  if (pulls_ >= legs_ - 1 + careful_pulls) return false;
  const int leg = ++pulls_;
  double weight = froda::pull_weight;
  for (int k = legs_; k < leg; ++k) weight *= weight_growth;
  const bool is_due = leg > 1 && (leg - 1) % options_.legs_a_look == 0;
  ask_for_pull(leg < legs_ ? double(leg) / legs_ : 1.0, leg > legs_ || is_due ? weight : 0.0);
  return true;
}

void FrodaFrame::ask_for_pull(double share, bool sees_contacts) {
  ask_for_pull(share, sees_contacts ? froda::pull_weight : 0.0);
}

/// With contacts of this weight; 0: blindly.
void FrodaFrame::ask_for_pull(double share, double weight) {
  const bool sees_contacts = weight > 0.0;
  if (sees_contacts) {
    find_rows(weight);
  } else {
    is_looked_at_ = false;
    rows_.clear();
  }
  set_targets(share);
  request_ = {target_, rows_, springs(sees_contacts), options_.bound * unit_,
              conjugate_gradients()};
}

/// Targets are set for working bodies, to which contacts add some.
void FrodaFrame::set_targets(double share) {
  const auto working = working_.bodies();
  if (share != target_share_) bodies_with_targets_ = 0;
  target_share_ = share;
  if (course_ != nullptr) return set_targets_on_course(share);
  for (const std::uint32_t body : working.subspan(bodies_with_targets_))
    for (Slot at = plan_.bodies()[body].first; at < plan_.bodies()[body].last; ++at)
      target_[at] = start_[at] + share * push_[at];
  bodies_with_targets_ = working.size();
}

/// Of all bodies: those of careful frames all work from the beginning.
void FrodaFrame::set_targets_on_course(double share) {
  const auto joint_at = plan_.joint_at();
  on_course_.resize(framework_.joint_count());
  course_->at(share, on_course_);
  for (std::size_t k = 0; k < joint_at.size(); ++k) target_[k] = on_course_[joint_at[k]] - origin_;
}

std::span<const TurnSpring> FrodaFrame::springs(bool are_wanted) {
  if (!are_wanted || !options_.has_torsion_preferences || springs_.empty()) return {};
  return springs_.at(x_, spring_weight);
}

bool FrodaFrame::ask_for_contacts() {
  const Violation worst = find_rows(options_.last_weight);
  const double here = std::max(worst.limit, worst.overlap);
  if (here <= options_.goal || pushes_ >= options_.last_steps) return false;
  ++pushes_;
  since_gain_ = here < froda::least_gain * least_ ? 0 : since_gain_ + 1;
  least_ = std::min(least_, here);
  const bool is_whole = least_ <= std::min(options_.limit, options_.overlap);
  if (since_gain_ >= (is_whole ? froda::patience : froda::long_patience)) return false;
  if (since_gain_ >= patience_with_springs) springs_let_go_ = true;
  request_ = {
      {}, rows_, springs(!springs_let_go_), froda::last_bound * unit_, conjugate_gradients()};
  return true;
}

bool FrodaFrame::ask_for_closing() {
  if (closings_ >= most_closings || plan_.widest_gap(x_) <= widest_closed * unit_) return false;
  if (closings_++ == 0) before_ = x_;
  rows_.clear();
  request_ = {{}, {}, {}, froda::last_bound * unit_, 0};
  return true;
}

void FrodaFrame::note_step() {
  ++steps_;
  visits_ += static_cast<std::int64_t>(working_.bodies().size());
  is_looked_at_ = false;
}

bool FrodaFrame::has_broken_contacts() {
  find_rows(froda::pull_weight);
  return !rows_.empty();
}

FrodaResult FrodaFrame::finish(std::span<Vec3> out) {
  FrodaResult result;
  result.max_closing = closings_ > 0 ? closing() : 0.0;
  const Violation worst = find_rows(options_.last_weight);
  result.max_limit = worst.limit;
  result.max_overlap = worst.overlap;
  result.is_whole = worst.limit <= options_.limit && worst.overlap <= options_.overlap &&
                    plan_.widest_gap(x_) <= 10.0 * widest_closed * unit_ &&
                    result.max_closing <= largest_closing * unit_;
  result.steps = steps_;
  result.visits = visits_;
  for (Joint joint = 0; joint < out.size(); ++joint)
    out[joint] = x_[plan_.place_of(joint)] + origin_;
  return result;
}

/// How far a joint went while loops were closed (Angstrom).
double FrodaFrame::closing() const {
  double furthest = 0.0;
  for (std::size_t k = 0; k < x_.size(); ++k)
    furthest = std::max(furthest, norm_squared(x_[k] - before_[k]));
  return std::sqrt(furthest);
}

FrodaFrame::Violation FrodaFrame::find_rows(double weight) {
  if (is_looked_at_) {
    for (DistanceRow& row : rows_) row.weight = weight;
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
void FrodaFrame::add_row(const DistanceRow& row, double broken) {
  const std::uint32_t one = plan_.tree_of(plan_.body_at()[row.i]);
  const std::uint32_t other = plan_.tree_of(plan_.body_at()[row.j]);
  if (!(broken > options_.goal) && !working_.holds(one) && !working_.holds(other)) return;
  rows_.push_back(row);
  working_.add(one);
  working_.add(other);
}

void FrodaFrame::find_limit_rows(double weight, Violation& worst) {
  const auto limits = framework_.limits();
  for (LimitIndex k = 0; k < limits.size(); ++k) {
    if (is_off(limits_off_, k)) continue;
    const Slot i = plan_.place_of(limits[k].a), j = plan_.place_of(limits[k].b);
    const froda::Aim aim = froda::aim_of(limits[k]);
    const Vec3 apart = x_[i] - x_[j];
    const double square = norm_squared(apart);
    if (square <= aim.most * aim.most && square >= aim.least * aim.least) continue;
    const double length = std::sqrt(square);
    const double broken = std::abs(excess(limits[k], length));
    worst.limit = std::max(worst.limit, broken);
    const double gap = (length > aim.most ? aim.most : aim.least) - length;
    add_row({i, j, (1.0 / (length + froda::least_length)) * apart, gap, weight}, broken);
  }
}

void FrodaFrame::find_steric_rows(double weight, Violation& worst) {
  pairs_->update(x_);
  for (const NearPair& pair : pairs_->pairs()) {
    const double aim = pair.least + froda::margin;
    const Vec3 apart = x_[pair.i] - x_[pair.j];
    const double square = norm_squared(apart);
    if (square >= aim * aim) continue;
    const double length = std::sqrt(square);
    const double broken = pair.least - length;
    worst.overlap = std::max(worst.overlap, broken);
    add_row({pair.i, pair.j, (1.0 / (length + froda::least_length)) * apart, aim - length, weight},
            broken);
  }
}

}  // namespace pliant
