// SPDX-License-Identifier: MIT
// The nearest placement of a tree of rigid units: turns all hinges at once so that the joints come
// as near as possible to given points, with least sum w |x - t|^2.
//
// An outward pass fits each unit to its own joints and swings all units beyond it; here these
// count, too. A Gauss-Newton step for all torsions equals the acceleration of a chain of rigid
// bodies at rest under forces w (t - x), which articulated body inertias give in linear time
// (Featherstone, Int. J. Robot. Res. 2 (1983) 13): inward
//
//   u_k = I_k s_k,  d_k = s_k . u_k,  I_parent += I_k - u_k u_k^T / d_k,
//   p_parent += p_k - u_k (s_k . p_k) / d_k
//
// then outward q_k = (s_k . p_k - u_k . v_parent) / d_k, v_k = v_parent + s_k q_k. I: 6 x 6 inertia
// of the joints of the unit, p: force and moment on them, s: twist of the hinge, v: twist of the
// unit.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/outward/unit_plan.hpp"
#include "pliant/resolve/bodies/tree/articulated_body.hpp"

namespace pliant {

class UnitNearest {
 public:
  /// Moves `positions` (N), at which the units of the plan are placed, by rigid motions of the
  /// units about their connections towards `targets` (N), until a step gains less than a thousandth
  /// of the sum. Does not move components with pinned joints.
  void approach(UnitPlan& plan, std::span<Vec3> positions, std::span<const Vec3> targets);

 private:
  /// Data of one unit: going inward it has an inertia and a force, going outward a twist in place
  /// of the force, and when moved a motion in place of the inertia. They share memory, because long
  /// chains have millions of bodies.
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
    /// Sets inertia and force to 0.
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
  /// of all bodies: a hinge has one, a body that begins a component none
  std::vector<BodyTurn> turns_;
  std::vector<std::uint32_t> first_turn_;  ///< of each unit, and one more
  std::vector<Vec3> kept_;                 ///< positions at the beginning of the step
  Vec3 origin_;
};

}  // namespace pliant
