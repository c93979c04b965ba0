// SPDX-License-Identifier: MIT
// One step of Gauss and Newton's method in torsion space, in linear time: bodies that hang on each
// other move towards places asked for, and contacts that are broken are mended.
//
// The steps of all torsions solve (H + sum w g g^T) q = f; H is the mass matrix of the bodies,
// which articulated body inertias invert in one pass inward and one outward (Featherstone, Int. J.
// Robot. Res. 2 (1983) 13). A contact joins two bodies that need not hang together, which would
// spoil the tree; by
//
//   (n.(v_i - v_j) - C)^2 <= 2 (n.v_i - C/2)^2 + 2 (n.v_j + C/2)^2
//
// it falls apart into one directional mass on each of them. The step is then that of a majorant, so
// that it never overshoots; conjugate gradients with it as their preconditioner come nearer to the
// step of the sum itself.
//
// Where loops of bodies were cut, the step is the nearest one (in the metric of H) that closes the
// gaps r to first order, v - H^-1 G^T (G H^-1 G^T)^-1 (G v - r), G the rows of the cuts: each takes
// one pass inward and outward. Steps that are asked for nothing close the loops by Newton's method.
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/froda/body_kernels.hpp"
#include "pliant/resolve/froda/body_plan.hpp"

namespace pliant {

/// Two places that are to move apart along `along`, from j to i, by `gap` (Angstrom; below 0:
/// together).
struct ContactRow {
  Slot i = 0, j = 0;
  Vec3 along;
  double gap = 0.0, weight = 0.0;
};

/// What a step is asked for.
struct StepRequest {
  std::span<const Vec3> targets = {};  ///< (places) where each should come to; empty: stay
  std::span<const ContactRow> rows = {};
  double bound = 1.0;           ///< Angstrom: no body goes further
  int conjugate_gradients = 0;  ///< products inside the step
};

class ArticulatedStep {
 public:
  /// The plan outlives it. Ten times the square of `unit` (Angstrom) is added to what a turn moves:
  /// damping.
  explicit ArticulatedStep(const BodyPlan& plan, double unit = 1.0);

  /// Moves `x` (places, Angstrom, near the origin): bodies turn about their hinges, whose shapes
  /// stay as they are to rounding.
  void step(std::span<Vec3> x, const StepRequest& request);

 private:
  struct Turn {
    Twist s{}, u{};
    double inverse = 0.0;  ///< 1 / (s . u + damping)
    double force = 0.0;    ///< s . p, going inward
    double angle = 0.0;    ///< radians
  };
  struct Motion {
    Vec3 rx, ry, rz, shift;  ///< rows of a rotation
    Vec3 operator()(Vec3 x) const {
      return {dot(rx, x) + shift.x, dot(ry, x) + shift.y, dot(rz, x) + shift.z};
    }
  };

  std::span<Turn> turns(const PlanBody& body) {
    return {turns_.data() + body.first_turn, body.turns()};
  }
  void gather(std::span<const Vec3> x, std::span<const Vec3> targets);
  void set_turns(std::span<const Vec3> x);
  void add_rows(std::span<const Vec3> x, std::span<const ContactRow> rows, double factor);
  void go_inward();
  void pass_on(const PlanBody& body, std::size_t index);
  void push_inward(std::vector<Twist>& forces);
  void go_outward(const std::vector<Twist>& forces);
  void refine(std::span<const Vec3> x, const StepRequest& request);
  void close_loops(std::span<const Vec3> x);
  void answer(const ContactRow& row, std::span<const Vec3> x);
  double apply_matrix(std::span<const Vec3> x, std::span<const ContactRow> rows);
  double share_of(std::span<const Vec3> x, double bound) const;
  void move(std::span<Vec3> x, double share);
  Motion motion_of(const PlanBody& body, std::size_t index, std::span<const Vec3> x,
                   double share) const;

  const BodyPlan& plan_;
  double square_unit_, damping_;
  std::vector<Inertia> inertia_;
  std::vector<Twist> force_, twist_;
  std::vector<Turn> turns_;
  std::vector<Motion> motion_;
  // of conjugate gradients
  std::vector<Inertia> plain_;
  std::vector<Twist> left_, room_, direction_, image_, sum_;
  std::vector<double> direction_angle_, sum_angle_;
  // of loops
  std::vector<ContactRow> cut_rows_;
  std::vector<std::vector<Twist>> answer_;         ///< of each row: twists of all bodies
  std::vector<std::vector<double>> answer_angle_;  ///< and angles of all turns
  std::vector<double> products_, factors_;
};

}  // namespace pliant
