// SPDX-License-Identifier: MIT
// Keeps loops of bodies closed: corrects a step of a forest of bodies so that the two places of
// each joint at which a loop was cut coincide to first order.
//
// The corrected step is the nearest one in the metric of the mass matrix H, v - H^-1 G^T (G H^-1
// G^T)^-1 (G v - r), with the rows G of the cuts and their gaps r. The factors of H^-1 are known: a
// force on a body goes inward over the turns between the body and its root, and f H^-1 g is the sum
// over those turns of the product of the two forces that arrive, divided by the turn's inertia
// (Rodriguez, Jain, Kreutz-Delgado, Int. J. Robot. Res. 10 (1991) 371). The length of a row is
// therefore that of the path to its root, however many bodies there are, and one pass corrects all
// bodies at the end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/tree/articulated_pass.hpp"

namespace pliant {

class CutClosing {
 public:
  /// Plan and trees must outlive it: it closes only the cuts of these trees.
  CutClosing(const BodyPlan& plan, const WorkingTrees& working);

  /// Corrects `motions` of `pass`, which has gone inward at `x`. Changes nothing if the equations
  /// cannot be solved.
  void correct(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions);

 private:
  using Three = std::array<double, 3>;
  /// The effect on a turn of unit forces along the axes, on one place of a cut and reversed on the
  /// other.
  struct Share {
    std::uint32_t turn;
    Three forces;
  };
  struct Root {
    std::uint32_t body = 0;
    std::array<Twist, 3> forces, answers;  ///< forces that arrive at the root, and its motions
  };

  void choose_cuts();
  void climb(const ArticulatedPass& pass, std::span<const Vec3> x, std::size_t cut);
  void take_turns(const ArticulatedPass& pass, std::uint32_t body, std::array<Twist, 3>& forces);
  void multiply(const ArticulatedPass& pass);
  std::array<Three, 3> product(std::size_t one, std::size_t other,
                               std::span<const ArticulatedPass::Turn> turns) const;
  void set_gaps(std::span<const Vec3> x, const BodyMotions& motions);
  void apply(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions);

  const BodyPlan& plan_;
  const WorkingTrees& working_;
  std::vector<LoopCut> cuts_;       ///< of working trees
  std::vector<Share> shares_;       ///< (cuts) turns descending
  std::vector<std::size_t> first_;  ///< (cuts + 1) into shares_
  std::vector<Root> roots_;         ///< (cuts)
  std::vector<double> products_, factors_;
  std::vector<Twist> forces_;
  BodyMotions correction_;
};

}  // namespace pliant
