// SPDX-License-Identifier: MIT
// Solves the normal equations of a step in torsion space in linear time. The steps q of all
// torsions solve (H + sum w g g^T) q = f. H is the mass matrix of the bodies, which articulated
// body inertias invert in one pass inward and one outward (Featherstone, Int. J. Robot. Res. 2
// (1983) 13).
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/bodies/tree/articulated_body.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "pliant/resolve/bodies/tree/turn_springs.hpp"
#include "pliant/resolve/bodies/tree/working_trees.hpp"

namespace pliant {

/// Two places that should move apart by `gap` along `along`, from j to i (Angstrom; negative:
/// together).
struct DistanceRow {
  static constexpr Slot still = ~Slot{0};  ///< as j: a point that stays where it is

  Slot i = 0, j = 0;
  Vec3 along;
  double gap = 0.0, weight = 0.0;

  /// Direction of the row for the body of a place at x: the effect of a unit force.
  Twist direction(Vec3 x) const { return twist_of(cross(x, along), along); }
};

/// A place that should move by `way` (Angstrom), `weight` times as strongly as towards its target.
struct PlacePull {
  Slot at = 0;
  Vec3 way;
  double weight = 0.0;
};

/// The motions of all bodies and turns.
struct BodyMotions {
  std::vector<Twist> twists;   ///< of bodies
  std::vector<double> angles;  ///< of turns, radians
};

class ArticulatedPass {
 public:
  /// One way in which a body turns relative to its parent.
  struct Turn {
    Twist s{}, u{};
    double inverse = 0.0;  ///< 1 / (s . u + damping)
    double force = 0.0;    ///< s . p and the spring, going inward
  };

  /// Plan and trees must outlive it; bodies of other trees are ignored. `damping` (Angstrom^2) is
  /// added to the inertia of each turn; `square_unit` is the square of the unit of length
  /// (Angstrom^2).
  ArticulatedPass(const BodyPlan& plan, const WorkingTrees& working, double damping,
                  double square_unit);

  /// Makes room for the plan after it has changed.
  void fit();

  /// Computes the inertias of the bodies at `x` (places, near the origin), the forces that pull
  /// them to `targets` (places; empty: none), and their turns.
  void gather(std::span<const Vec3> x, std::span<const Vec3> targets);
  /// Adds the mass of each pull, and its force, to the body of its place.
  void add_pulls(std::span<const Vec3> x, std::span<const PlacePull> pulls);
  /// Adds each row as a directional mass of `factor` times its weight on both of its bodies.
  void add_rows(std::span<const Vec3> x, std::span<const DistanceRow> rows, double factor);
  /// Eliminates turns from inertias and forces, from the last body to the roots. `springs` (turns)
  /// pull on them; empty: none.
  void go_inward(std::span<const TurnSpring> springs = {});
  /// Eliminates turns from other forces, of bodies and, if not empty, of turns, as go_inward() did
  /// from the gathered ones.
  void push_inward(std::vector<Twist>& forces, std::span<const double> of_turns = {});
  /// The motions of bodies under `forces`, which must have gone inward last.
  void go_outward(const std::vector<Twist>& forces, BodyMotions& out) const;

  /// Eliminates the turns of a body, with forces `of_turns` (turns; empty: 0), from a force on it
  /// alone, and calls note(turn, its force).
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
  /// The motion of a root under a force; the ground has none.
  Twist answer_of_root(std::uint32_t root, const Twist& force) const {
    if (plan_.is_ground(root)) return Twist{};
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
