// SPDX-License-Identifier: MIT
// Keeps loops of bodies closed: corrects a step of a forest of bodies so that the two places of
// each joint at which a loop was cut coincide to first order.
//
// The corrected step is the nearest one in the metric of the mass matrix H, v - H^-1 G^T (G H^-1
// G^T)^-1 (G v - r), with the rows G of the cuts and their gaps r. The factors of H^-1 are known: a
// force on a body goes inward over the turns between the body and its root, and f H^-1 g is the sum
// over those turns of the product of the two forces that arrive, divided by the turn's inertia
// (Rodriguez, Jain, Kreutz-Delgado, Int. J. Robot. Res. 10 (1991) 371). All cuts of a tree
// therefore go inward together: each turn adds to the products of those that pass it. Trees have
// nothing to do with each other, and one pass corrects all bodies at the end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/resolve/bodies/tree/articulated_pass.hpp"

namespace pliant {

class CutClosing {
 public:
  /// Plan and trees must outlive it: it closes only the cuts of these trees.
  CutClosing(const BodyPlan& plan, const WorkingTrees& working);

  /// Corrects `motions` of `pass`, which has gone inward at `x`. A tree whose equations cannot be
  /// solved is left as it is.
  void correct(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions);

 private:
  using Three = std::array<double, 3>;
  /// A cut on its way to the root: forces go there from both of its places, until they meet.
  enum class From : std::uint8_t { copy, joint, both };
  struct Passing {
    std::uint32_t cut;
    From from;  ///< both: here they meet
  };

  bool close_tree(const ArticulatedPass& pass, std::span<const Vec3> x, const BodyMotions& motions,
                  std::span<const LoopCut> cuts);
  void find_ways(const BodyTree& tree, std::span<const LoopCut> cuts);
  void start_forces(std::span<const Vec3> x, std::span<const LoopCut> cuts);
  void go_through(const ArticulatedPass& pass, std::uint32_t body,
                  std::span<const Passing> passing);
  void add_turn(double inverse, std::span<const Passing> passing, const Three* along);
  void add_root(const ArticulatedPass& pass, std::uint32_t root, std::span<const Passing> passing);
  void regularize();
  void set_gaps(std::span<const Vec3> x, const BodyMotions& motions, std::span<const LoopCut> cuts);
  void add_closing_forces(std::span<const Vec3> x, std::span<const LoopCut> cuts);
  void apply(ArticulatedPass& pass, BodyMotions& motions);
  std::array<Twist, 3>& forces_of(const Passing& passing) {
    return (passing.from == From::joint ? of_joints_ : of_copies_)[passing.cut];
  }

  const BodyPlan& plan_;
  const WorkingTrees& working_;
  std::vector<LoopCut> cuts_;  ///< of working trees, by tree
  // The rest is of one tree at a time, but for forces_ and correction_.
  Grouped<Passing> ways_;                                    ///< of each body, by cut
  std::vector<std::array<Twist, 3>> of_copies_, of_joints_;  ///< (cuts) unit forces along the axes
  std::vector<Three> along_;  ///< what arrives at the turns of a body, of each that passes
  std::vector<double> products_, factors_;
  std::vector<Twist> forces_;  ///< (bodies) those that close the cuts
  BodyMotions correction_;
};

}  // namespace pliant
