// SPDX-License-Identifier: MIT
// One step of Gauss and Newton's method in torsion space, in linear time: bodies that hang on each
// other move towards places asked for, and contacts that are broken are mended.
//
// A contact joins two bodies that need not hang together, which would spoil the tree; by
//
//   (n.(v_i - v_j) - C)^2 <= 2 (n.v_i - C/2)^2 + 2 (n.v_j + C/2)^2
//
// it falls apart into one directional mass on each of them. The step is then that of a majorant, so
// that it never overshoots; conjugate gradients with it as their preconditioner come nearer to the
// step of the sum itself. Where loops of bodies were cut, the step is corrected so that they close;
// steps that are asked for nothing close them by Newton's method.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/froda/bodies/articulated_pass.hpp"
#include "pliant/resolve/froda/bodies/cut_closing.hpp"

namespace pliant {

namespace froda {

// Of a step, alone and in lanes.
inline constexpr double largest_turn = 0.5;  // radians
inline constexpr double damping = 10.0;
inline constexpr double tiny = 1e-30;
/// Of each of the two directional masses of a row, so that their sum is above the row.
inline constexpr double majorant = 2.0;

}  // namespace froda

/// What a step is asked for.
struct StepRequest {
  std::span<const Vec3> targets = {};  ///< (places) where each should come to; empty: stay
  std::span<const ContactRow> rows = {};
  std::span<const TurnSpring> springs = {};  ///< (turns) what pulls on them; empty: nothing
  double bound = 1.0;                        ///< Angstrom: no body goes further
  int conjugate_gradients = 0;               ///< products inside the step
};

class ArticulatedStep {
 public:
  /// Plan and trees outlive it: it moves these trees alone. Ten times the square of `unit`
  /// (Angstrom) is added to what a turn moves: damping.
  ArticulatedStep(const BodyPlan& plan, const WorkingTrees& working, double unit = 1.0);

  /// Moves `x` (places, Angstrom, near the origin): bodies turn about their hinges, whose shapes
  /// stay as they are to rounding. How far the one that goes furthest goes, to first order
  /// (Angstrom).
  double step(std::span<Vec3> x, const StepRequest& request);

 private:
  struct Motion {
    Vec3 rx, ry, rz, shift;  ///< rows of a rotation
    Vec3 operator()(Vec3 x) const {
      return {dot(rx, x) + shift.x, dot(ry, x) + shift.y, dot(rz, x) + shift.z};
    }
  };

  /// How much of a step is taken, and how far it then moves some body (Angstrom).
  struct Share {
    double of_step, furthest;
  };

  void refine(std::span<const Vec3> x, const StepRequest& request);
  double apply_matrix(std::span<const Vec3> x, const StepRequest& request);
  static Twist pull_of(const PlanBody& body, const Twist& twist, std::span<const Vec3> x);
  double add_row(const ContactRow& row, std::span<const Vec3> x);
  double resistance(const StepRequest& request, std::size_t turn) const;
  Share share_of(std::span<const Vec3> x, double bound) const;
  void move(std::span<Vec3> x, double share);
  Motion motion_of(const PlanBody& body, std::size_t index, std::span<const Vec3> x,
                   double share) const;

  const BodyPlan& plan_;
  const WorkingTrees& working_;
  ArticulatedPass pass_;
  std::unique_ptr<CutClosing> closing_;  ///< null: no loops
  BodyMotions motions_;
  std::vector<Motion> motion_;
  // of conjugate gradients
  std::vector<Twist> left_, room_, image_;
  std::vector<double> left_of_turns_;
  BodyMotions direction_, sum_;
};

}  // namespace pliant
