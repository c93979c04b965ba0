// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/unit_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

/// Relative error of a hinge that counts as wrong: pinned joints may hold one apart.
constexpr double most_hinge_error = 1e-6;

/// The direction from one point to the other; false if there is none.
bool direction_of(Vec3 from, Vec3 to, double& length, Vec3& out) {
  length = distance(from, to);
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  out = (1.0 / length) * (to - from);
  return true;
}

/// A unit vector at right angles to `axis`, as near as it goes to where `u`, at right angles to
/// `from`, comes by the shortest turn from `from` to `axis`.
Vec3 carried(Vec3 u, Vec3 from, Vec3 axis) {
  constexpr double nearly_opposite = -0.99;
  const double cosine = dot(from, axis);
  if (!(cosine > nearly_opposite)) return AxisBasis(axis).e1;
  u -= (dot(u, axis) / (1.0 + cosine)) * (from + axis);
  u -= dot(u, axis) * axis;
  return (1.0 / norm(u)) * u;
}

}  // namespace

bool UnitAhead::place(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets) {
  targets_ = targets;
  units_.assign(plan.steps().size(), {});
  nominal_.assign(targets.begin(), targets.end());
  if (!find_places(plan, positions)) return false;
  go_inward(plan.steps());
  return go_outward(plan, positions);
}

bool UnitAhead::find_places(UnitPlan& plan, std::span<const Vec3> positions) {
  const auto steps = plan.steps();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const UnitStep& step = steps[k];
    HingedUnit& unit = units_[k];
    if (step.is<UnitStep::Still>() && step.is_held) {
      if (step.count == 0) continue;
      const JointInUnit& first = plan.joints(step)[0];
      unit.place.origin = positions[first.joint] - first.from_point();
    } else if (!find_place(plan, step, unit.place)) {
      return false;
    }
    gather(plan, step, unit);
    set_turns(step, unit);
  }
  return true;
}

bool UnitAhead::find_place(UnitPlan& plan, const UnitStep& step, Place& place) const {
  if (const auto* hinge = std::get_if<UnitStep::Hinge>(&step.entry))
    return find_place_at(plan, step, *hinge, place);
  if (const auto* rod = std::get_if<UnitStep::Rod>(&step.entry)) {
    double length = 0.0;
    place.origin = targets_[step.a];
    if (!direction_of(place.origin, targets_[rod->b], length, place.along)) return false;
    const AxisBasis basis(place.along);
    place.u = basis.e1;
    place.v = basis.e2;
    return true;
  }
  if (step.is<UnitStep::Ball>()) return find_place_about(plan, step, targets_[step.a], place);
  double sum = 0.0;
  Vec3 centroid;
  for (const JointInUnit& joint : plan.joints(step)) {
    centroid += joint.weight * targets_[joint.joint];
    sum += joint.weight;
  }
  return find_place_about(plan, step, (1.0 / sum) * centroid, place);
}

bool UnitAhead::find_place_about(UnitPlan& plan, const UnitStep& step, Vec3 point,
                                 Place& place) const {
  RotationFit fit;
  for (const JointInUnit& joint : plan.joints(step))
    fit.add(joint.from_point(), targets_[joint.joint] - point, joint.weight);
  Rotation rotation;
  const auto outcome = fit.solve(step.mirror_allowed, rotation);
  if (outcome == RotationFit::Fit::not_finite || outcome == RotationFit::Fit::undefined)
    return false;
  place.origin = point;
  const double sign = outcome == RotationFit::Fit::mirrored ? -1.0 : 1.0;
  place.along = sign * place.along;
  place.u = sign * place.u;
  place.v = sign * place.v;
  place.turn(rotation);
  return true;
}

bool UnitAhead::find_place_at(UnitPlan& plan, const UnitStep& step, const UnitStep::Hinge& hinge,
                              Place& place) const {
  double length = 0.0;
  place.origin = targets_[step.a];
  if (!direction_of(place.origin, targets_[hinge.b], length, place.along)) return false;
  const AxisBasis basis(place.along);
  TurnAboutHinge turned(place.origin, basis);
  for (const JointInUnit& joint : plan.joints(step))
    turned.add(joint.from_hinge(), targets_[joint.joint], joint.weight);
  TorsionFit::Turn turn = turned.best(step.mirror_allowed);
  if (!std::isfinite(turn.strength)) return false;
  if (turn.strength == 0.0) turn = {};  // all its joints are on the line
  place.u = turn.cosine * basis.e1 + turn.sine * basis.e2;
  place.v = turn.v_sign * (turn.cosine * basis.e2 - turn.sine * basis.e1);
  return true;
}

/// Its own joints, as the nominal place has them.
void UnitAhead::gather(UnitPlan& plan, const UnitStep& step, HingedUnit& unit) {
  const auto* rod = std::get_if<UnitStep::Rod>(&step.entry);
  for (const JointInUnit& joint : plan.joints(step)) {
    Vec3& at = nominal_[joint.joint];
    at = unit.place(joint.from_hinge());
    if (rod != nullptr && joint.joint == rod->b)
      at = unit.place.origin + rod->length * unit.place.along;
    add_point(unit.inertia, unit.force, at - unit.place.origin, targets_[joint.joint] - at,
              step.scale * joint.weight);
  }
}

void UnitAhead::set_turns(const UnitStep& step, HingedUnit& unit) {
  unit.turn_count = step.turns();
  const std::array<Vec3, 3> axes =
      step.is<UnitStep::Rod>()     ? std::array{unit.place.u, unit.place.v, Vec3{}}
      : step.is<UnitStep::Hinge>() ? std::array{unit.place.along, Vec3{}, Vec3{}}
                                   : std::array{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (std::size_t k = 0; k < unit.turn_count; ++k) unit.turns[k].s = turn_of(axes[k], {});
}

void UnitAhead::go_inward(std::span<const UnitStep> steps) {
  for (std::size_t k = steps.size(); k-- > 0;) {
    HingedUnit& unit = units_[k];
    for (std::size_t t = unit.turn_count; t-- > 0;)
      unit.turns[t].eliminate(unit.inertia, unit.force);
    if (steps[k].parent < 0) continue;
    const UnitStep& above = steps[std::size_t(steps[k].parent)];
    HingedUnit& parent = units_[std::size_t(steps[k].parent)];
    const Vec3 a = nominal(above, parent, steps[k].a);
    Twist carried_by{};
    if (const auto* hinge = std::get_if<UnitStep::Hinge>(&steps[k].entry)) {
      const Vec3 b = nominal(above, parent, hinge->b);
      carried_by = seen_from(unit.place, a, &b);
    } else {
      carried_by = seen_from(unit.place, a, nullptr);
    }
    const Twist lost = froda::product(unit.inertia, carried_by);
    for (std::size_t i = 0; i < 6; ++i) unit.force[i] -= lost[i];
    add_body(parent.inertia, parent.force, unit.inertia, unit.force,
             unit.place.origin - parent.place.origin);
  }
}

/// Where the nominal place of a unit has a joint of it.
Vec3 UnitAhead::nominal(const UnitStep& step, const HingedUnit& unit, Joint joint) const {
  if (step.moves_freely() || step.is<UnitStep::Still>()) return nominal_[joint];
  if (joint == step.a) return unit.place.origin;
  const auto* hinge = std::get_if<UnitStep::Hinge>(&step.entry);
  if (hinge != nullptr && joint == hinge->b)
    return unit.place.origin + hinge->length * unit.place.along;
  return nominal_[joint];
}

/// How a hinge from `a` to `b`, or a ball at `a`, lies against a nominal place: about its origin.
Twist UnitAhead::seen_from(const Place& place, Vec3 a, const Vec3* b) {
  Vec3 turn;
  if (b != nullptr) {
    const Vec3 along = *b - a;
    turn = (1.0 / norm(along)) * cross(place.along, along);
  }
  return twist_of(turn, a - place.origin);
}

bool UnitAhead::go_outward(UnitPlan& plan, std::span<Vec3> positions) {
  for (std::size_t k = 0; k < units_.size(); ++k)
    if (!settle(plan, k, positions)) return false;
  return true;
}

bool UnitAhead::settle(UnitPlan& plan, std::size_t index, std::span<Vec3> positions) {
  const UnitStep& step = plan.steps()[index];
  HingedUnit& unit = units_[index];
  Place place = unit.place;
  const auto* hinge = std::get_if<UnitStep::Hinge>(&step.entry);
  const auto* rod = std::get_if<UnitStep::Rod>(&step.entry);
  Twist twist{};
  if (step.moves_freely()) {
    if (rod != nullptr) std::fill(unit.inertia.begin(), unit.inertia.begin() + 6, 0.0);
    twist = solve_free(unit.inertia, unit.force);
    place.origin += lower_of(twist);
  } else if (!step.is<UnitStep::Still>()) {
    place.origin = positions[step.a];
    twist = seen_from(unit.place, place.origin, hinge != nullptr ? &positions[hinge->b] : nullptr);
  }
  if (hinge != nullptr && !lay_along(*hinge, unit.place, positions[hinge->b], place)) return false;
  Vec3 turn = step.moves_freely() ? upper_of(twist) : Vec3{};
  for (std::size_t t = 0; t < unit.turn_count; ++t) {
    unit.turns[t].settle(twist);
    turn += unit.turns[t].angle * (hinge != nullptr ? place.along : unit.turns[t].axis());
  }
  const Rotation rotation = turn_by(turn);
  if (hinge == nullptr) place.along = rotation(place.along);
  place.u = rotation(place.u);
  place.v = rotation(place.v);
  if (!is_finite(place.origin) || !is_finite(place.along) || !is_finite(place.u)) return false;
  if (rod != nullptr) place.along *= rod->length / norm(place.along);
  put_joints(plan, step, place, positions);
  return true;
}

/// Turns a place at the start of the hinge so that it lies along it, by the shortest turn; false
/// if the hinge has no direction or not its length.
bool UnitAhead::lay_along(const UnitStep::Hinge& hinge, const Place& nominal, Vec3 end,
                          Place& place) {
  double length = 0.0;
  if (!direction_of(place.origin, end, length, place.along)) return false;
  if (!(std::abs(length - hinge.length) <= most_hinge_error * hinge.length)) return false;
  const bool mirrored = dot(cross(nominal.along, nominal.u), nominal.v) < 0.0;
  place.u = carried(nominal.u, nominal.along, place.along);
  place.v = (mirrored ? -1.0 : 1.0) * cross(place.along, place.u);
  return true;
}

void UnitAhead::put_joints(UnitPlan& plan, const UnitStep& step, const Place& place,
                           std::span<Vec3> positions) {
  const auto* rod = std::get_if<UnitStep::Rod>(&step.entry);
  for (const JointInUnit& joint : plan.joints(step)) {
    Vec3& x = positions[joint.joint];
    x = place(joint.from_hinge());
    if (rod != nullptr && joint.joint == rod->b) x = place.origin + place.along;
  }
}

}  // namespace pliant
