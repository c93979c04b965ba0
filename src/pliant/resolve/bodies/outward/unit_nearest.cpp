// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/unit_nearest.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr int most_steps = 20;
constexpr int most_halvings = 6;
/// A step that takes less than this share off the sum was the last.
constexpr double least_gain = 1e-3;
constexpr double largest_turn = 0.5;  // radians

}  // namespace

void UnitNearest::approach(UnitPlan& plan, std::span<Vec3> positions,
                           std::span<const Vec3> targets) {
  const auto steps = plan.steps();
  units_.resize(steps.size());
  first_turn_.assign(1, 0);
  first_turn_.reserve(steps.size() + 1);
  for (const UnitStep& step : steps)
    first_turn_.push_back(first_turn_.back() + static_cast<std::uint32_t>(step.turns()));
  turns_.resize(first_turn_.back());
  kept_.assign(positions.begin(), positions.end());
  for (int step = 0; step < most_steps; ++step) {
    const double before = gather(plan, positions, targets);
    go_inward(steps);
    go_outward(steps);
    std::copy(positions.begin(), positions.end(), kept_.begin());
    if (!(step_nearer(plan, positions, targets, before) < (1.0 - least_gain) * before)) return;
  }
}

/// Goes as far along the turns found as pays; returns the sum there.
double UnitNearest::step_nearer(UnitPlan& plan, std::span<Vec3> positions,
                                std::span<const Vec3> targets, double before) {
  double share = longest_share();
  for (int halving = 0; halving <= most_halvings; ++halving, share *= 0.5) {
    const double sum = move(plan, share, positions, targets);
    if (sum < before) return sum;
  }
  std::copy(kept_.begin(), kept_.end(), positions.begin());
  return before;
}

/// Inertias and forces of all units; the sum to make least.
double UnitNearest::gather(UnitPlan& plan, std::span<const Vec3> positions,
                           std::span<const Vec3> targets) {
  double sum = 0.0;
  const auto steps = plan.steps();
  if (!steps.empty()) origin_ = positions[steps[steps.size() / 2].a];
  for (std::size_t k = 0; k < steps.size(); ++k) {
    HingedUnit& unit = units_[k];
    unit.begin();
    for (const JointInUnit& joint : plan.joints(steps[k])) {
      const Vec3 pull = targets[joint.joint] - positions[joint.joint];
      const double weight = steps[k].scale * joint.weight;
      add_point(unit.inertia, unit.force, positions[joint.joint] - origin_, pull, weight);
      sum += weight * norm_squared(pull);
    }
    set_turns(steps[k], k, positions);
  }
  return sum;
}

void UnitNearest::set_turns(const UnitStep& step, std::size_t index,
                            std::span<const Vec3> positions) {
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  if (const Joint* second = step.second()) {
    const Vec3 along = positions[*second] - positions[step.a];
    const AxisBasis basis((1.0 / norm(along)) * along);
    axes = {basis.e1, basis.e2, basis.axis};
    if (step.is<UnitStep::Hinge>()) axes[0] = basis.axis;
  }
  const Vec3 through = positions[step.a] - origin_;
  std::size_t t = 0;
  for (BodyTurn& turn : turns(index)) turn.s = turn_of(axes[t++], through);
}

void UnitNearest::go_inward(std::span<const UnitStep> steps) {
  for (std::size_t k = steps.size(); k-- > 0;) {
    HingedUnit& unit = units_[k];
    const std::span<BodyTurn> own = turns(k);
    for (std::size_t t = own.size(); t-- > 0;) own[t].eliminate(unit.inertia, unit.force);
    if (steps[k].parent < 0) continue;
    HingedUnit& parent = units_[std::size_t(steps[k].parent)];
    for (std::size_t i = 0; i < 21; ++i) parent.inertia[i] += unit.inertia[i];
    for (std::size_t i = 0; i < 6; ++i) parent.force[i] += unit.force[i];
  }
}

/// From here on bodies have twists.
void UnitNearest::go_outward(std::span<const UnitStep> steps) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    HingedUnit& unit = units_[k];
    if (steps[k].parent >= 0) {
      unit.twist = units_[std::size_t(steps[k].parent)].twist;
    } else {
      if (steps[k].is<UnitStep::Rod>())  // its turns are two, and what is left shifts it
        std::fill(unit.inertia.begin(), unit.inertia.begin() + 6, 0.0);
      unit.twist = steps[k].is_held ? Twist{} : solve_free(unit.inertia, unit.force);
    }
    for (BodyTurn& turn : turns(k)) turn.settle(unit.twist);
  }
}

double UnitNearest::longest_share() const {
  double largest = 0.0;
  for (std::size_t k = 0; k < units_.size(); ++k) largest = std::max(largest, norm(turn_vector(k)));
  return largest > largest_turn ? largest_turn / largest : 1.0;
}

/// Moves all units from where they were by a share of the step; the sum there.
double UnitNearest::move(UnitPlan& plan, double share, std::span<Vec3> positions,
                         std::span<const Vec3> targets) {
  const auto steps = plan.steps();
  double sum = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    set_motion(steps[k], k, share);
    const RigidMotion& motion = units_[k].motion;
    for (const JointInUnit& joint : plan.joints(steps[k])) {
      Vec3& x = positions[joint.joint];
      x = origin_ + motion(kept_[joint.joint] - origin_);
      sum += steps[k].scale * joint.weight * norm_squared(targets[joint.joint] - x);
    }
  }
  return sum;
}

void UnitNearest::set_motion(const UnitStep& step, std::size_t index, double share) {
  RigidMotion motion;
  if (step.parent >= 0) {
    motion = units_[std::size_t(step.parent)].motion;
  } else if (!step.is_held) {
    const Twist& twist = units_[index].twist;
    const Vec3 turn{twist[0], twist[1], twist[2]};
    const double angle = norm(turn);
    if (angle > 0.0) motion.rotation = turn_about((1.0 / angle) * turn, 0.5 * share * angle);
    motion.shift = share * Vec3{twist[3], twist[4], twist[5]};
  }
  const Vec3 turn = turn_vector(index);
  const double angle = norm(turn);
  if (angle > 0.0) {
    const Vec3 through = kept_[step.a] - origin_;
    const Rotation rotation = turn_about((1.0 / angle) * turn, 0.5 * share * angle);
    motion = motion.after(rotation, through);
  }
  units_[index].set(motion);
}

/// Axis times angle of the turns of a unit together (radians).
Vec3 UnitNearest::turn_vector(std::size_t index) const {
  Vec3 sum;
  for (const BodyTurn& turn : turns(index)) sum += turn.angle * turn.axis();
  return sum;
}

}  // namespace pliant
