// SPDX-License-Identifier: MIT
#include "pliant/resolve/units/unit_nearest.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Twist = std::array<double, 6>;

constexpr int most_steps = 20;
constexpr int most_halvings = 6;
/// A step that takes less than this share off the sum was the last.
constexpr double least_gain = 1e-3;
constexpr double largest_turn = 0.5;  // radians
/// A turn that moves less than this, against what the inertia could give, moves nothing.
constexpr double vanishing = 1e-12;

std::size_t entry(std::size_t i, std::size_t j) {
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

Twist times(const std::array<double, 21>& inertia, const Twist& s) {
  Twist out{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) out[i] += inertia[entry(i, j)] * s[j];
  return out;
}

double dot6(const Twist& a, const Twist& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k) sum += a[k] * b[k];
  return sum;
}

Twist twist_of(Vec3 upper, Vec3 lower) {
  return {upper.x, upper.y, upper.z, lower.x, lower.y, lower.z};
}

/// Adds a point of weight w at x, pulled by w times `pull`.
void add_point(std::array<double, 21>& a, Twist& force, Vec3 x, Vec3 pull, double w) {
  const Vec3 wx = w * x;
  const double square = dot(wx, x);
  a[0] += square - wx.x * x.x;
  a[1] -= wx.y * x.x;
  a[2] += square - wx.y * x.y;
  a[3] -= wx.z * x.x;
  a[4] -= wx.z * x.y;
  a[5] += square - wx.z * x.z;
  a[7] += wx.z;
  a[8] -= wx.y;
  a[9] += w;
  a[10] -= wx.z;
  a[12] += wx.x;
  a[14] += w;
  a[15] += wx.y;
  a[16] -= wx.x;
  a[20] += w;
  const Vec3 f = w * pull, moment = cross(x, f);
  const Twist add = twist_of(moment, f);
  for (std::size_t k = 0; k < 6; ++k) force[k] += add[k];
}

/// Solves inertia v = force; directions without inertia (a rod about itself) stay.
Twist solve_free(std::array<double, 21> a, Twist b) {
  for (std::size_t j = 0; j < 6; ++j) {
    const double diagonal = a[entry(j, j)];
    for (std::size_t k = 0; k < j; ++k)
      a[entry(j, j)] -= a[entry(j, k)] * a[entry(j, k)] * a[entry(k, k)];
    const double pivot = a[entry(j, j)];
    const bool vanishes = !(pivot > vanishing * diagonal);
    if (vanishes) a[entry(j, j)] = HUGE_VAL;
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = a[entry(i, j)];
      for (std::size_t k = 0; k < j; ++k) {
        const double share = a[entry(i, k)] * a[entry(j, k)];
        if (share != 0.0) sum -= share * a[entry(k, k)];
      }
      a[entry(i, j)] = vanishes ? 0.0 : sum / pivot;
    }
  }
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[entry(i, k)] * b[k];
  for (std::size_t i = 0; i < 6; ++i) b[i] /= a[entry(i, i)];
  for (std::size_t i = 6; i-- > 0;)
    for (std::size_t k = i + 1; k < 6; ++k) b[i] -= a[entry(k, i)] * b[k];
  return b;
}

std::size_t turns_of(const UnitStep& step) {
  if (step.is<UnitStep::Rod>()) return 2;  // not about itself
  if (step.parent < 0 && !step.is_held) return 0;
  return step.is<UnitStep::Hinge>() ? 1 : 3;
}

}  // namespace

void UnitNearest::approach(UnitPlan& plan, std::span<Vec3> positions,
                           std::span<const Vec3> targets) {
  const auto steps = plan.steps();
  units_.resize(steps.size());
  first_turn_.assign(1, 0);
  first_turn_.reserve(steps.size() + 1);
  for (const UnitStep& step : steps)
    first_turn_.push_back(first_turn_.back() + static_cast<std::uint32_t>(turns_of(step)));
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

/// As far along the turns found as pays; the sum there.
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
  for (Turn& turn : turns(index)) {
    turn.s = twist_of(axes[t], cross(through, axes[t]));
    ++t;
  }
}

void UnitNearest::go_inward(std::span<const UnitStep> steps) {
  for (std::size_t k = steps.size(); k-- > 0;) {
    HingedUnit& unit = units_[k];
    const std::span<Turn> own = turns(k);
    for (std::size_t t = own.size(); t-- > 0;) eliminate(unit, own[t]);
    if (steps[k].parent < 0) continue;
    HingedUnit& parent = units_[std::size_t(steps[k].parent)];
    for (std::size_t i = 0; i < 21; ++i) parent.inertia[i] += unit.inertia[i];
    for (std::size_t i = 0; i < 6; ++i) parent.force[i] += unit.force[i];
  }
}

void UnitNearest::eliminate(HingedUnit& unit, Turn& turn) const {
  turn.u = times(unit.inertia, turn.s);
  turn.d = dot6(turn.s, turn.u);
  turn.angle = dot6(turn.s, unit.force);
  double most = 0.0;
  for (std::size_t i = 0; i < 6; ++i) most += turn.s[i] * turn.s[i] * unit.inertia[entry(i, i)];
  if (!(turn.d > vanishing * most)) turn.d = 0.0;
  if (turn.d == 0.0) return;
  for (std::size_t i = 0; i < 6; ++i) {
    const double share = turn.u[i] / turn.d;
    unit.force[i] -= share * turn.angle;
    for (std::size_t j = 0; j <= i; ++j) unit.inertia[entry(i, j)] -= share * turn.u[j];
  }
}

/// From here on units have twists.
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
    for (Turn& turn : turns(k)) {
      turn.angle = turn.d > 0.0 ? (turn.angle - dot6(turn.u, unit.twist)) / turn.d : 0.0;
      for (std::size_t i = 0; i < 6; ++i) unit.twist[i] += turn.angle * turn.s[i];
    }
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
  for (const Turn& turn : turns(index)) sum += turn.angle * turn.axis();
  return sum;
}

}  // namespace pliant
