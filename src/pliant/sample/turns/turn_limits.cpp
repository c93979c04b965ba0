// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_limits.hpp"

#include <cmath>

#include "pliant/sample/turns/hinges.hpp"

namespace pliant {
namespace {

// Angstrom, between alpha carbons
constexpr double widest_gap = 6.0;     // of a link: the torsions beside it can close that
constexpr double near_distance = 4.0;  // of nodes that are no neighbours
/// So many pairs, and as many for a hundred nodes, may come too near: they are pushed apart.
constexpr double most_new_pairs = 2.0, most_new_pairs_a_node = 0.01;

}  // namespace

TurnLimits::TurnLimits(const NetworkNodes& nodes)
    : nodes_(nodes), near_at_start_(pairs_within(near_distance, nodes, nodes.positions)) {}

bool TurnLimits::allow(std::span<const Vec3> moved) const {
  for (std::size_t i = 0; i + 1 < moved.size(); ++i) {
    if (nodes_.chain[i] != nodes_.chain[i + 1]) continue;
    const double before = distance(nodes_.positions[i], nodes_.positions[i + 1]);
    if (std::abs(distance(moved[i], moved[i + 1]) - before) > widest_gap) return false;
  }
  const double most = most_new_pairs + most_new_pairs_a_node * double(moved.size());
  return double(pairs_within(near_distance, nodes_, moved)) <= double(near_at_start_) + most;
}

std::vector<Vec3> moved_nodes(const NetworkNodes& nodes, const PieceTree& tree,
                              std::span<const PieceTurn> turns) {
  TurnCourse course(nodes, tree);
  const auto motions = course.motions(turns, 1.0);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < motions.size(); ++i) out.push_back(motions[i](nodes.positions[i]));
  return out;
}

}  // namespace pliant
