// SPDX-License-Identifier: MIT
// Keeps loops of bodies closed: corrects a step of bodies that hang on each other as a forest so
// that the two places of each joint at which a loop was cut come to lie together, to first order.
//
// The corrected step is the nearest one in the metric of the mass matrix H,
// v - H^-1 G^T (G H^-1 G^T)^-1 (G v - r), G the rows of the cuts and r their gaps. H^-1 is known by
// its factors: a force on a body goes inward over the turns between the body and its root, and
// f H^-1 g is the sum over those turns of what f and g do to each, by its inverse inertia
// (Rodriguez, Jain, Kreutz-Delgado, Int. J. Robot. Res. 10 (1991) 371). So a row is as long as the
// way to its root, however many bodies there are, and one pass corrects all bodies at the end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/froda/bodies/articulated_pass.hpp"

namespace pliant {

class CutClosing {
 public:
  /// Plan and trees outlive it: it closes the cuts of these trees alone.
  CutClosing(const BodyPlan& plan, const WorkingTrees& working);

  /// Corrects `motions`, which `pass` (gone inward at `x`) gave. Changes nothing if the equations
  /// cannot be solved.
  void correct(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions);

 private:
  using Three = std::array<double, 3>;
  /// What unit forces along the axes, one way on one place of a cut and back on the other, do to a
  /// turn.
  struct Share {
    std::uint32_t turn;
    Three forces;
  };
  struct Root {
    std::uint32_t body = 0;
    std::array<Twist, 3> forces, answers;  ///< what arrives there, and how it moves
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
  std::vector<Share> shares_;       ///< of each cut, turns descending
  std::vector<std::size_t> first_;  ///< (cuts + 1) into shares_
  std::vector<Root> roots_;         ///< of each cut
  std::vector<double> products_, factors_;
  std::vector<Twist> forces_;
  BodyMotions correction_;
};

}  // namespace pliant
