// SPDX-License-Identifier: MIT
// From modes of nodes to displacements of all joints: each goes with its node, and turns with the
// node's neighbours.
//
//   d(x) = u_i + w_i x (x - x_i),   w_i = argmin sum_j |u_j - u_i - w x (x_j - x_i)|^2
//
// over nodes j within 8 Angstrom of i. No node goes further than a cap: linear displacements of
// ends of chains would tear what they carry.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/sample/network/network_modes.hpp"

namespace pliant {

/// How far a node goes at most (Angstrom).
inline constexpr double largest_node_move = 8.0;

class ModeDisplacement {
 public:
  /// `nodes` as the modes have them; `start` (N) are the joints, each of which goes with its node,
  /// or if it has none with the nearest.
  ModeDisplacement(const NetworkNodes& nodes, NetworkModes modes, std::span<const Vec3> start);

  std::size_t mode_count() const { return modes_.variances.size(); }

  /// out[j] (N, Angstrom) of joint j for `amplitudes` (K) in standard deviations of the modes.
  void displacements(std::span<const double> amplitudes, std::span<Vec3> out) const;

 private:
  void add_turns(double reach);
  std::vector<Vec3> moves_of_nodes(std::span<const double> amplitudes) const;
  Vec3 turn_of(std::size_t node, std::span<const Vec3> moves) const;

  NetworkModes modes_;
  std::vector<Vec3> nodes_, start_;
  std::vector<std::uint32_t> of_joint_;
  Grouped<std::uint32_t> neighbours_;
  std::vector<std::array<double, 9>> inverse_;  ///< of sum |r|^2 - r r^T, or 0 if it has none
};

}  // namespace pliant
