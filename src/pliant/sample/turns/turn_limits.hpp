// SPDX-License-Identifier: MIT
// How far nodes may be turned: what links that open and nodes that come too near allow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/sample/turns/turn_course.hpp"

namespace pliant {

class TurnLimits {
 public:
  /// `nodes` must outlive it.
  explicit TurnLimits(const NetworkNodes& nodes);

  /// Whether links can be closed, and few nodes are nearer to each other than at the start.
  bool allow(std::span<const Vec3> moved) const;

 private:
  const NetworkNodes& nodes_;
  std::size_t near_at_start_;
};

/// (M, Angstrom) where turns take the nodes.
std::vector<Vec3> moved_nodes(const NetworkNodes& nodes, const PieceTree& tree,
                              std::span<const PieceTurn> turns);

}  // namespace pliant
