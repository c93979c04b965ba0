// SPDX-License-Identifier: MIT
// A guess of a way: pieces of a molecule turn as wholes, along arcs, and lift off while they do.
#pragma once

#include <span>
#include <vector>

#include "pliant/sample/turns/turn_course.hpp"

namespace pliant {

/// Not thread-safe.
class TurnGuess {
 public:
  /// From the nodes (M) to `end` (M, Angstrom), which lies such that the first piece stays. The
  /// piece `lifted`, and all that hangs on it, are 10 Angstrom further from the rest half-way. What
  /// the turns leave of the way is gone in straight lines meanwhile, as seen from the pieces. Nodes
  /// and tree must outlive it.
  TurnGuess(const NetworkNodes& nodes, const PieceTree& tree, std::span<const Vec3> end,
            std::vector<PieceTurn> turns, std::uint32_t lifted);

  /// (M) the motion of each node at a share of the way, from 0 to 1.
  std::vector<RigidMotion> motions(double share);
  /// How deep nodes of the lifted part and others are within 4 Angstrom of each other, summed over
  /// looks along the way (Angstrom^2).
  double clashes();
  /// r.m.s. length of the way of the nodes, superposed (Angstrom).
  double length();

 private:
  std::vector<Vec3> places(double share);
  void find_lifted(const PieceTree& tree, std::uint32_t lifted);
  double lifted_near(std::size_t node, const PieceTree& tree,
                     std::span<const std::uint8_t> is_lifted) const;
  Vec3 away_from_rest(std::span<const RigidMotion> motions) const;

  const NetworkNodes& nodes_;
  std::vector<PieceTurn> turns_;
  TurnCourse course_;
  std::vector<double> lifted_;  ///< (M) share of the lift that each node takes part in
  std::vector<Vec3> rest_;      ///< (M) Angstrom, of the way, as each node lies at the start
};

/// The motion back.
RigidMotion inverse(const RigidMotion& motion);

}  // namespace pliant
