// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/sample/turns/two_lobes.hpp"

namespace pliant {
namespace {

std::vector<Vec3> drawn_nodes(const TurnDraws& draws, const NetworkNodes& nodes,
                              std::uint64_t frame) {
  RandomSequence random({7, Domain::turn, 0, frame, 0});
  const DrawnTurns drawn = draws.draw(random);
  EXPECT_NE(drawn.tree, nullptr);
  if (drawn.tree == nullptr) return nodes.positions;
  for (const PieceTurn& turn : drawn.turns) {
    EXPECT_NEAR(norm(turn.axis), 1.0, 1e-12);
    EXPECT_GE(turn.angle, 0.0);
    EXPECT_LE(turn.angle, std::numbers::pi);
  }
  TurnCourse course(nodes, *drawn.tree);
  const auto motions = course.motions(drawn.turns, 1.0);
  std::vector<Vec3> out;
  for (std::size_t k = 0; k < motions.size(); ++k) out.push_back(motions[k](nodes.positions[k]));
  return out;
}

constexpr std::size_t lobes = 2 * test::lobe_nodes + test::strand_nodes;

std::size_t near_pairs(std::span<const Vec3> nodes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = i + 3; j < nodes.size(); ++j)
      count += distance(nodes[i], nodes[j]) <= 4.0 ? 1 : 0;
  return count;
}

TEST(TurnDraws, LinksStayShortAndNodesApart) {
  const NetworkNodes nodes = test::two_lobes();
  const TurnDraws draws(nodes, network_modes(nodes));
  ASSERT_FALSE(draws.empty());
  const double most = double(near_pairs(nodes.positions)) + 2.0 + 0.01 * double(lobes);
  double furthest = 0.0;
  for (std::uint64_t frame = 0; frame < 60; ++frame) {
    const std::vector<Vec3> moved = drawn_nodes(draws, nodes, frame);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      furthest = std::max(furthest, distance(moved[i], nodes.positions[i]));
      if (i > 0) EXPECT_NEAR(distance(moved[i], moved[i - 1]), 3.8, 6.0 + 1e-9);
    }
    EXPECT_LE(double(near_pairs(moved)), most) << frame;
  }
  EXPECT_GT(furthest, 15.0) << "turns reach further than straight displacements";
}

TEST(TurnDraws, AFrameDependsOnItsNumberAlone) {
  const NetworkNodes nodes = test::two_lobes();
  const TurnDraws one(nodes, network_modes(nodes)), other(nodes, network_modes(nodes));
  drawn_nodes(one, nodes, 1);
  EXPECT_EQ(drawn_nodes(one, nodes, 5), drawn_nodes(other, nodes, 5));
  EXPECT_NE(drawn_nodes(one, nodes, 5), drawn_nodes(one, nodes, 6));
}

}  // namespace
}  // namespace pliant
