// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_course.hpp"

#include <algorithm>
#include <numbers>

#include "pliant/base/math/axis_angle.hpp"

namespace pliant {
namespace {

constexpr std::int64_t spread_over = 6;                // nodes on each side of a link
constexpr double half_turn = std::numbers::pi - 1e-9;  // radians

}  // namespace

std::span<const RigidMotion> TurnCourse::motions(std::span<const PieceTurn> turns, double share) {
  move_pieces(turns, share);
  motions_.resize(tree_.of_node.size());
  for (std::size_t i = 0; i < motions_.size(); ++i) motions_[i] = pieces_[tree_.of_node[i]];
  for (const ChainLink link : tree_.links) spread(link);
  return motions_;
}

/// Each piece goes with its parent, and turns.
void TurnCourse::move_pieces(std::span<const PieceTurn> turns, double share) {
  pieces_.assign(tree_.piece_count(), {});
  turned_.assign(tree_.piece_count(), {});
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    if (tree_.parent[p] >= 0) pieces_[p] = pieces_[static_cast<std::size_t>(tree_.parent[p])];
    const auto turn = std::find_if(turns.begin(), turns.end(),
                                   [&](const PieceTurn& one) { return one.piece == p; });
    if (turn == turns.end()) continue;
    turned_[p] = {turn->axis, share * turn->angle};
    pieces_[p] = pieces_[p].after(rotation_by(turn->axis, turned_[p].angle), turn->pivot);
  }
}

/// How the second piece is turned against the first. From half a turn on their rotations do not say
/// which way round.
AxisAngle TurnCourse::turn_between(std::uint32_t one, std::uint32_t other) const {
  const auto is_long = [&](std::uint32_t piece, std::uint32_t parent) {
    return tree_.parent[piece] == static_cast<std::int32_t>(parent) &&
           turned_[piece].angle > half_turn;
  };
  const auto gone = [&](std::uint32_t piece, double sign) {
    return AxisAngle{sign * pieces_[piece].rotation(turned_[piece].axis), turned_[piece].angle};
  };
  if (is_long(other, one)) return gone(other, 1.0);
  if (is_long(one, other)) return gone(one, -1.0);
  return axis_angle(product(pieces_[other].rotation, inverse(pieces_[one].rotation)));
}

/// Nodes beside a link turn about its middle by a part of what one piece turns against the other.
void TurnCourse::spread(ChainLink link) {
  const std::uint32_t one = tree_.of_node[link.before], other = tree_.of_node[link.after];
  const RigidMotion &from = pieces_[one], &to = pieces_[other];
  const AxisAngle turn = turn_between(one, other);
  const Vec3 middle = 0.5 * (nodes_.positions[link.before] + nodes_.positions[link.after]);
  const Vec3 start = from(middle), end = to(middle);
  if (turn.angle == 0.0 && norm_squared(end - start) == 0.0) return;
  for (std::int64_t k = 1 - spread_over; k <= spread_over; ++k) {
    const std::int64_t at = std::int64_t{link.before} + k;
    if (at < 0 || at >= static_cast<std::int64_t>(motions_.size())) continue;
    const auto node = static_cast<std::size_t>(at);
    if (nodes_.chain[node] != nodes_.chain[link.before]) continue;
    if (tree_.of_node[node] != one && tree_.of_node[node] != other) continue;
    const double part = (double(k + spread_over) - 0.5) / double(2 * spread_over);
    const Rotation rotation = product(rotation_by(turn.axis, part * turn.angle), from.rotation);
    const Vec3 goal = start + part * (end - start);
    motions_[node] = {rotation, goal - rotation(middle)};
  }
}

}  // namespace pliant
