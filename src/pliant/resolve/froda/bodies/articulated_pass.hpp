// SPDX-License-Identifier: MIT
// The normal equations of a step in torsion space, solved in linear time. The steps of all torsions
// solve (H + sum w g g^T) q = f; H is the mass matrix of the bodies, which articulated body
// inertias invert in one pass inward and one outward (Featherstone, Int. J. Robot. Res. 2 (1983)
// 13).
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/froda/bodies/body_kernels.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"
#include "pliant/resolve/froda/bodies/turn_springs.hpp"
#include "pliant/resolve/froda/bodies/working_trees.hpp"

namespace pliant {

/// Two places that are to move apart along `along`, from j to i, by `gap` (Angstrom; below 0:
/// together).
struct ContactRow {
  Slot i = 0, j = 0;
  Vec3 along;
  double gap = 0.0, weight = 0.0;

  /// What a unit force along the row does to the body of a place at x.
  Twist direction(Vec3 x) const { return twist_of(cross(x, along), along); }
};

/// How all bodies and turns move.
struct BodyMotions {
  std::vector<Twist> twists;   ///< of bodies
  std::vector<double> angles;  ///< of turns, radians
};

class ArticulatedPass {
 public:
  /// One way in which a body turns against its parent.
  struct Turn {
    Twist s{}, u{};
    double inverse = 0.0;  ///< 1 / (s . u + damping)
    double force = 0.0;    ///< s . p and the spring, going inward
  };

  /// Plan and trees outlive it; bodies of other trees are left out of all below. `damping`
  /// (Angstrom^2) is added to what a turn moves; `square_unit`: of lengths, Angstrom^2.
  ArticulatedPass(const BodyPlan& plan, const WorkingTrees& working, double damping,
                  double square_unit);

  /// Inertias of the bodies at `x` (places, near the origin), the forces that pull them to
  /// `targets` (places; empty: none), and their turns.
  void gather(std::span<const Vec3> x, std::span<const Vec3> targets);
  /// Adds each row as a directional mass of `factor` times its weight on each of its two bodies.
  void add_rows(std::span<const Vec3> x, std::span<const ContactRow> rows, double factor);
  /// Takes turns out of inertias and forces, from the last body to the roots. `springs` (turns)
  /// pull on them; empty: none do.
  void go_inward(std::span<const TurnSpring> springs = {});
  /// Does to other forces, of bodies and (empty: none) of turns, what go_inward() did to those that
  /// were gathered.
  void push_inward(std::vector<Twist>& forces, std::span<const double> of_turns = {});
  /// How bodies move under `forces`, which have gone inward last.
  void go_outward(const std::vector<Twist>& forces, BodyMotions& out) const;

  /// Takes the turns of a body, on which `of_turns` pull (turns; empty: nothing), out of a force on
  /// it alone, and calls note(turn, its force).
  template <class Note>
  void carry(std::uint32_t body, Twist& force, const Note& note,
             std::span<const double> of_turns = {}) const {
    const PlanBody& of = plan_.bodies()[body];
    for (std::uint32_t t = of.first_turn + of.turns(); t-- > of.first_turn;) {
      const Turn& turn = turns_[t];
      const double along = froda::dot(turn.s, force) + (of_turns.empty() ? 0.0 : of_turns[t]);
      froda::add_scaled(-along * turn.inverse, turn.u, force);
      note(t, along);
    }
  }
  /// How a root moves under a force.
  Twist answer_of_root(std::uint32_t root, const Twist& force) const {
    return froda::solve6(inertia_[root], force, square_unit_);
  }

  const std::vector<Twist>& forces() const { return force_; }
  const std::vector<Turn>& turns() const { return turns_; }
  double damping() const { return damping_; }

 private:
  std::span<Turn> turns_of(const PlanBody& body) {
    return {turns_.data() + body.first_turn, body.turns()};
  }
  void set_turns(std::span<const Vec3> x);
  void pass_on(const PlanBody& body, std::size_t index, std::span<const TurnSpring> springs);

  const BodyPlan& plan_;
  const WorkingTrees& working_;
  double damping_, square_unit_;
  std::vector<Inertia> inertia_;
  std::vector<Twist> force_;
  std::vector<Turn> turns_;
};

}  // namespace pliant
