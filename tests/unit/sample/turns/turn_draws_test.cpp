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

TEST(TurnDraws, LinksStayShortAndNodesApart) {
  const NetworkNodes nodes = test::two_lobes();
  const TurnDraws draws(nodes, network_modes(nodes));
  ASSERT_FALSE(draws.empty());
  double furthest = 0.0;
  for (std::uint64_t frame = 0; frame < 60; ++frame) {
    const std::vector<Vec3> moved = drawn_nodes(draws, nodes, frame);
    int near = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      furthest = std::max(furthest, distance(moved[i], nodes.positions[i]));
      if (i > 0) EXPECT_LE(distance(moved[i], moved[i - 1]), 3.8 + 6.0 + 1e-9);
      for (std::size_t j = i + 3; j < moved.size(); ++j)
        near += distance(moved[i], moved[j]) < 3.7 ? 1 : 0;
    }
    EXPECT_LE(near, 2) << frame;
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
