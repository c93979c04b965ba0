// SPDX-License-Identifier: MIT
// The outward pass that looks ahead: places every unit once, as UnitPass does, but each where what
// hangs on it can still come near its joints, and not only where its own joints fit best.
//
// A pass that looks at one unit at a time is unstable: what it cannot correct at one unit, the
// next has to bear with the lever between them, and the error grows by a factor from unit to unit
// until it is a swing. So the cost of each place of a unit for all that hangs on it,
// sum w |x - t|^2 with their best turns, is found first, going inward, to second order about the
// place that the unit would have alone (its nominal place); then, going outward, each unit takes
// the turn q that costs least from where its hinge came to lie:
//
//   inward    p_child -= u (s . p_child) / d,  I_child -= u u^T / d,  p_child -= I_child c,
//             I += I_child,  p += p_child
//   outward   q = (s . p - u . v) / d
//
// I, p: inertia and force of the unit's own joints and of what its children add. c: a twist, how
// the child's hinge lies when this unit's nominal place carries it, against the child's nominal
// place. v: the same as the hinge came to lie.
//
// This is the optimal feedback of a linear system with quadratic cost (Bellman; Jacobson and Mayne,
// Differential Dynamic Programming, 1970) with articulated body inertias as its matrices; what is
// left out of second order at one unit is seen and corrected at the next.
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/units/articulated_body.hpp"
#include "pliant/resolve/units/unit_plan.hpp"

namespace pliant {

class UnitAhead {
 public:
  /// Places all units of the plan near `targets` (N), and writes every joint of `positions` (N)
  /// that is not pinned. The shapes of all steps are set; Still units that are held have theirs in
  /// `positions`. False, with anything in `positions`, if a unit or a hinge has no direction or
  /// something is not finite.
  bool place(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets);

 private:
  /// Where the own system of a unit lies: HingePoint or place from a point, to space.
  struct Place {
    Vec3 origin, along{1, 0, 0}, u{0, 1, 0}, v{0, 0, 1};
    Vec3 operator()(HingePoint at) const {
      return origin + (at.along * along + at.u * u + at.v * v);
    }
    void turn(const Rotation& rotation) {
      along = rotation(along);
      u = rotation(u);
      v = rotation(v);
    }
  };
  struct HingedUnit {
    Inertia inertia{};  ///< about the origin of `place`
    Twist force{};
    Place place;  ///< nominal
    std::array<BodyTurn, 3> turns;
    std::size_t turn_count = 0;
  };

  bool find_places(UnitPlan& plan, std::span<const Vec3> positions);
  bool find_place(UnitPlan& plan, const UnitStep& step, Place& place) const;
  bool find_place_about(UnitPlan& plan, const UnitStep& step, Vec3 point, Place& place) const;
  bool find_place_at(UnitPlan& plan, const UnitStep& step, const UnitStep::Hinge& hinge,
                     Place& place) const;
  void gather(UnitPlan& plan, const UnitStep& step, HingedUnit& unit);
  static void set_turns(const UnitStep& step, HingedUnit& unit);
  void go_inward(std::span<const UnitStep> steps);
  Vec3 nominal(const UnitStep& step, const HingedUnit& unit, Joint joint) const;
  static Twist seen_from(const Place& place, Vec3 a, const Vec3* b);
  bool go_outward(UnitPlan& plan, std::span<Vec3> positions);
  bool settle(UnitPlan& plan, std::size_t index, std::span<Vec3> positions);
  static bool lay_along(const UnitStep::Hinge& hinge, const Place& nominal, Vec3 end, Place& place);
  static void put_joints(UnitPlan& plan, const UnitStep& step, const Place& place,
                         std::span<Vec3> positions);

  std::span<const Vec3> targets_;
  std::vector<HingedUnit> units_;  ///< of the steps of the plan
  std::vector<Vec3> nominal_;      ///< (N) in the nominal place of the unit that places the joint
};

}  // namespace pliant
