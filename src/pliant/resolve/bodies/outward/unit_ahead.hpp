// SPDX-License-Identifier: MIT
// The outward pass that looks ahead: places every unit once, as UnitPass does, but where the units
// beyond it can still come near their joints, not only where its own joints fit best.
//
// A pass that considers one unit at a time is unstable: an error that it cannot correct at one unit
// acts on the next with a lever, and grows by a factor from unit to unit. Therefore the cost of
// each placement of a unit for everything beyond it, sum w |x - t|^2 with its best turns, is first
// found going inward, to second order about the placement that the unit would have alone (its
// nominal placement). Then, going outward, each unit takes the turn q that costs least given the
// placement of its hinge:
//
//   inward    p_child -= u (s . p_child) / d,  I_child -= u u^T / d,  p_child -= I_child c,
//             I += I_child,  p += p_child
//   outward   q = (s . p - u . v) / d
//
// I, p: inertia and force of the unit's own joints with the contributions of its children. c: the
// twist from the child's nominal placement to where this unit's nominal placement carries its
// hinge. v: the same for the hinge's final placement.
//
// This is the optimal feedback of a linear system with quadratic cost (Bellman; Jacobson and Mayne,
// Differential Dynamic Programming, 1970) with articulated body inertias as its matrices; errors of
// second order at one unit are corrected at the next.
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/bodies/outward/unit_plan.hpp"
#include "pliant/resolve/bodies/tree/articulated_body.hpp"

namespace pliant {

class UnitAhead {
 public:
  /// Places all units of the plan near `targets` (N), and writes every joint of `positions` (N)
  /// that is not pinned. The shapes of all steps must be set; Still units that are held have theirs
  /// in `positions`. Returns false, with undefined `positions`, if a unit or a hinge has no
  /// direction or something is not finite.
  bool place(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets);

 private:
  /// Maps a unit's own coordinates, as HingePoint or relative to a point, to space.
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
    Place place;  ///< nominal placement
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
  std::vector<Vec3> nominal_;  ///< (N) in the nominal placement of the unit that places the joint
};

}  // namespace pliant
