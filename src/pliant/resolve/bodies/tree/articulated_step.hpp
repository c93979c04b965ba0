// SPDX-License-Identifier: MIT
// One step of the Gauss-Newton method in torsion space, in linear time: connected bodies move
// towards targets, and broken contacts are repaired.
//
// A contact joins two bodies that need not be connected, which would spoil the tree. By
//
//   (n.(v_i - v_j) - C)^2 <= 2 (n.v_i - C/2)^2 + 2 (n.v_j + C/2)^2
//
// it is split into one directional mass on each of them. The step is then that of a majorant, so
// that it never overshoots; conjugate gradients with it as their preconditioner approach the step
// of the sum itself. If loops of bodies were cut, the step is corrected so that they close; steps
// with an empty request close them by Newton's method.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/tree/articulated_pass.hpp"
#include "pliant/resolve/bodies/tree/cut_closing.hpp"

namespace pliant {

namespace froda {

// Constants of a step, alone and in lanes.
inline constexpr double largest_turn = 0.5;  // radians
inline constexpr double damping = 10.0;
inline constexpr double tiny = 1e-30;
/// Factor of both directional masses of a row, which makes their sum an upper bound of the row.
inline constexpr double majorant = 2.0;

}  // namespace froda

/// The request of a step.
struct StepRequest {
  std::span<const Vec3> targets = {};  ///< (places) where each should come to; empty: stay
  std::span<const DistanceRow> rows = {};
  std::span<const TurnSpring> springs = {};  ///< (turns) springs on them; empty: none
  double bound = 1.0;                        ///< largest displacement of a body (Angstrom)
  int conjugate_gradients = 0;               ///< iterations inside the step
  std::span<const PlacePull> pulls = {};     ///< beside the targets; not with conjugate gradients
};

class ArticulatedStep {
 public:
  /// Plan and trees must outlive it: it moves only these trees. Ten times the square of `unit`
  /// (Angstrom) is added to the inertia of each turn as damping.
  ArticulatedStep(const BodyPlan& plan, const WorkingTrees& working, double unit = 1.0);

  /// Makes room for the plan after it has changed.
  void fit();

  /// Moves `x` (places, Angstrom, near the origin): bodies turn about their hinges and keep their
  /// shapes to rounding. Returns the largest displacement of a body, to first order (Angstrom).
  double step(std::span<Vec3> x, const StepRequest& request);

 private:
  struct Motion {
    Vec3 rx, ry, rz, shift;  ///< rows of a rotation
    Vec3 operator()(Vec3 x) const {
      return {dot(rx, x) + shift.x, dot(ry, x) + shift.y, dot(rz, x) + shift.z};
    }
  };

  /// The share of a step that is taken, and the largest displacement of a body then (Angstrom).
  struct Share {
    double of_step, furthest;
  };

  void refine(std::span<const Vec3> x, const StepRequest& request);
  double apply_matrix(std::span<const Vec3> x, const StepRequest& request);
  static Twist pull_of(const PlanBody& body, const Twist& twist, std::span<const Vec3> x);
  double add_row(const DistanceRow& row, std::span<const Vec3> x);
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
  // Scratch of conjugate gradients.
  std::vector<Twist> left_, room_, image_;
  std::vector<double> left_of_turns_;
  BodyMotions direction_, sum_;
};

}  // namespace pliant
