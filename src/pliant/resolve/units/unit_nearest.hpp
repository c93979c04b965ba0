// SPDX-License-Identifier: MIT
// The nearest place of a tree of rigid units: turns all hinges at once so that the joints come as
// near as they can to given points, sum w |x - t|^2 least.
//
// An outward pass fits each unit to its own joints and swings all that hangs on it; this counts
// what hangs on it too. One step of Gauss and Newton's method for all torsions is what the
// acceleration of a chain of rigid bodies at rest under forces w (t - x) is, and is found in linear
// time as that is, by articulated body inertias (Featherstone, Int. J. Robot. Res. 2 (1983) 13):
// inward
//
//   u_k = I_k s_k,  d_k = s_k . u_k,  I_parent += I_k - u_k u_k^T / d_k,
//   p_parent += p_k - u_k (s_k . p_k) / d_k
//
// then outward q_k = (s_k . p_k - u_k . v_parent) / d_k, v_k = v_parent + s_k q_k. I: 6 x 6 inertia
// of the joints of the unit, p: force and moment on them, s: the twist of the hinge, v: twist.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/units/articulated_body.hpp"
#include "pliant/resolve/units/unit_plan.hpp"

namespace pliant {

class UnitNearest {
 public:
  /// Moves `positions` (N), at which the units of the plan are placed, by rigid motions of the
  /// units about their connections towards `targets` (N), until a step gains less than a thousandth
  /// of the sum. Components with pinned joints stay.
  void approach(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets);

 private:
  /// What a pass knows of one unit: going inward it has an inertia and a force, going outward it
  /// gets a twist in place of the force, and moved it has a motion in place of the inertia. They
  /// share their room: on long chains there are millions of bodies.
  struct HingedUnit {
    union {
      Inertia inertia;
      RigidMotion motion;  ///< of a step, from the origin
    };
    union {
      Twist force;
      Twist twist;
    };

    HingedUnit() { begin(); }
    /// Without inertia and force.
    void begin() {
      std::construct_at(&inertia);
      std::construct_at(&force);
    }
    void set(const RigidMotion& now) { std::construct_at(&motion, now); }
  };

  double gather(UnitPlan& plan, std::span<const Vec3> positions, std::span<const Vec3> targets);
  void set_turns(const UnitStep& step, std::size_t index, std::span<const Vec3> positions);
  void go_inward(std::span<const UnitStep> steps);
  void go_outward(std::span<const UnitStep> steps);
  Vec3 turn_vector(std::size_t index) const;
  std::span<BodyTurn> turns(std::size_t index) {
    return {turns_.data() + first_turn_[index], turns_.data() + first_turn_[index + 1]};
  }
  std::span<const BodyTurn> turns(std::size_t index) const {
    return {turns_.data() + first_turn_[index], turns_.data() + first_turn_[index + 1]};
  }
  double longest_share() const;
  double step_nearer(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets,
                     double before);
  double move(UnitPlan& plan, double share, std::span<Vec3> positions,
              std::span<const Vec3> targets);
  void set_motion(const UnitStep& step, std::size_t index, double share);

  std::vector<HingedUnit> units_;  ///< of the steps of the plan
  std::vector<BodyTurn> turns_;    ///< of all bodies: hinges have one, what begins a component none
  std::vector<std::uint32_t> first_turn_;  ///< of each unit, and one more
  std::vector<Vec3> kept_;                 ///< where the step began
  Vec3 origin_;
};

}  // namespace pliant
