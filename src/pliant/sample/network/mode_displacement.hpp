// SPDX-License-Identifier: MIT
// From modes of nodes to displacements of all joints: each joint moves with its node, and rotates
// as the node's neighbours do.
//
//   d(x) = u_i + w_i x (x - x_i),   w_i = argmin sum_j |u_j - u_i - w x (x_j - x_i)|^2
//
// over nodes j within 8 Angstrom of i. Displacements of nodes are limited, because large linear
// displacements of chain ends would tear what hangs on them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/sample/network/network_modes.hpp"

namespace pliant {

/// Largest displacement of a node (Angstrom).
inline constexpr double largest_node_move = 8.0;

/// (N) The node with which each joint moves: its own, or the nearest to its position in `start` if
/// it has none.
std::vector<std::uint32_t> nodes_of_joints(const NetworkNodes& nodes, std::span<const Vec3> start);

class ModeDisplacement {
 public:
  /// `nodes` are those of the modes; `start` (N) are the joints, each of which moves with its node,
  /// or with the nearest if it has none.
  ModeDisplacement(const NetworkNodes& nodes, NetworkModes modes, std::span<const Vec3> start);

  std::size_t mode_count() const { return modes_.variances.size(); }

  /// out[j] (N, Angstrom) is the displacement of joint j for `amplitudes` (K) in standard
  /// deviations of the modes.
  void displacements(std::span<const double> amplitudes, std::span<Vec3> out) const;

 private:
  void add_turns(double reach);
  Vec3 turn_of(std::size_t node, std::span<const Vec3> moves) const;

  NetworkModes modes_;
  std::vector<Vec3> nodes_, start_;
  std::vector<std::uint32_t> of_joint_;
  Grouped<std::uint32_t> neighbours_;
  /// inverse of sum |r|^2 - r r^T, or 0 if it is singular
  std::vector<std::array<double, 9>> inverse_;
};

}  // namespace pliant
