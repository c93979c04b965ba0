// SPDX-License-Identifier: MIT
// Pieces turned as wholes: where each joint goes while they turn.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/sample/turns/pieces.hpp"

namespace pliant {

/// A turn of a piece, and of all that hangs on it, relative to its parent.
struct PieceTurn {
  std::uint32_t piece = 0;
  Vec3 axis;           ///< unit length, as the molecule lies at the start
  Vec3 pivot;          ///< a point of the axis (Angstrom)
  double angle = 0.0;  ///< radians, 0 to 2 pi: above pi it is the long way round
};

/// Not thread-safe.
class TurnCourse {
 public:
  /// Both must outlive it; `nodes` (M) are those that `tree` divides.
  TurnCourse(const NetworkNodes& nodes, const PieceTree& tree) : nodes_(nodes), tree_(tree) {}

  /// The rigid motion of each node (M) when each turn has gone so far, from 0 to 1. The turn
  /// between two pieces is spread over the six nodes on each side of their links.
  std::span<const RigidMotion> motions(std::span<const PieceTurn> turns, double share);

 private:
  void move_pieces(std::span<const PieceTurn> turns, double share);
  void spread(ChainLink link);
  AxisAngle turn_between(std::uint32_t one, std::uint32_t other) const;

  const NetworkNodes& nodes_;
  const PieceTree& tree_;
  std::vector<RigidMotion> pieces_, motions_;
  std::vector<AxisAngle> turned_;  ///< (P) against the parent, as the molecule lies at the start
};

}  // namespace pliant
