// SPDX-License-Identifier: MIT
#include "pliant/path/turn_guess.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/path/path_walker.hpp"

namespace pliant {
namespace {

constexpr double lift = 10.0;           // Angstrom, about two side chains
constexpr double clash = 4.0;           // Angstrom
constexpr int looks = 20;               // at a way
constexpr std::size_t lift_smooth = 4;  // nodes on each side over which the lift is spread

}  // namespace

RigidMotion inverse(const RigidMotion& motion) {
  const Rotation back = inverse(motion.rotation);
  return {back, -1.0 * back(motion.shift)};
}

TurnGuess::TurnGuess(const NetworkNodes& nodes, const PieceTree& tree, std::span<const Vec3> end,
                     std::vector<PieceTurn> turns, std::uint32_t lifted)
    : nodes_(nodes), turns_(std::move(turns)), course_(nodes, tree) {
  find_lifted(tree, lifted);
  const auto motions = course_.motions(turns_, 1.0);
  for (std::size_t i = 0; i < end.size(); ++i)
    rest_.push_back(inverse(motions[i])(end[i]) - nodes.positions[i]);
}

std::vector<RigidMotion> TurnGuess::motions(double share) {
  const auto turned = course_.motions(turns_, share);
  std::vector<RigidMotion> out(turned.begin(), turned.end());
  for (std::size_t i = 0; i < out.size(); ++i) out[i].shift += out[i].rotation(share * rest_[i]);
  const double height = lift * exact_bits_cos(std::numbers::pi * (share - 0.5));
  const Vec3 up = height * away_from_rest(out);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].shift += lifted_[i] * up;
  return out;
}

double TurnGuess::clashes() {
  double sum = 0.0;
  for (int look = 1; look < looks; ++look) {
    const std::vector<Vec3> x = places(double(look) / looks);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = i + 1; j < x.size(); ++j) {
        if ((lifted_[i] < 0.5) == (lifted_[j] < 0.5)) continue;
        const double depth = std::max(0.0, clash - distance(x[i], x[j]));
        sum += depth * depth;
      }
  }
  return sum;
}

double TurnGuess::length() {
  double sum = 0.0;
  std::vector<Vec3> before = nodes_.positions;
  for (int look = 1; look <= looks; ++look) {
    std::vector<Vec3> now = places(double(look) / looks);
    sum += rms(ways(before, now));
    before = std::move(now);
  }
  return sum;
}

std::vector<Vec3> TurnGuess::places(double share) {
  const std::vector<RigidMotion> now = motions(share);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < now.size(); ++i) out.push_back(now[i](nodes_.positions[i]));
  return out;
}

void TurnGuess::find_lifted(const PieceTree& tree, std::uint32_t lifted) {
  std::vector<std::uint8_t> is_lifted(tree.piece_count(), 0);
  is_lifted[lifted] = 1;
  for (std::size_t p = lifted + 1; p < is_lifted.size(); ++p)
    is_lifted[p] = is_lifted[static_cast<std::size_t>(tree.parent[p])];
  for (std::size_t i = 0; i < tree.of_node.size(); ++i)
    lifted_.push_back(lifted_near(i, tree, is_lifted));
}

/// Beside links pieces take part in it the less, the nearer the link.
double TurnGuess::lifted_near(std::size_t node, const PieceTree& tree,
                              std::span<const std::uint8_t> is_lifted) const {
  double sum = 0.0, count = 0.0;
  const std::size_t last = std::min(node + lift_smooth, tree.of_node.size() - 1);
  for (std::size_t j = node - std::min(node, lift_smooth); j <= last; ++j) {
    if (nodes_.chain[node] != nodes_.chain[j]) continue;
    sum += is_lifted[tree.of_node[j]];
    count += 1.0;
  }
  return sum / count;
}

/// From the middle of the rest to that of the lifted part, of length 1.
Vec3 TurnGuess::away_from_rest(std::span<const RigidMotion> motions) const {
  Vec3 lifted, rest;
  double count = 0.0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Vec3 x = motions[i](nodes_.positions[i]);
    lifted += lifted_[i] * x;
    rest += (1.0 - lifted_[i]) * x;
    count += lifted_[i];
  }
  const Vec3 apart = (1.0 / count) * lifted - (1.0 / (double(motions.size()) - count)) * rest;
  const double length = norm(apart);
  return length > 0.0 ? (1.0 / length) * apart : Vec3{};
}

}  // namespace pliant
