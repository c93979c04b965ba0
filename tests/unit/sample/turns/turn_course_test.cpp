// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/sample/turns/two_lobes.hpp"

namespace pliant {
namespace {

class TurnCourseTest : public testing::Test {
 protected:
  TurnCourseTest() {
    tree.parent = {-1, 0};
    for (std::size_t k = 0; k < nodes.positions.size(); ++k)
      tree.of_node.push_back(k < cut ? 0 : 1);
    tree.links = {{cut - 1, cut}};
    turn = {.piece = 1,
            .axis = {0, 0, 1},
            .pivot = 0.5 * (nodes.positions[cut - 1] + nodes.positions[cut]),
            .angle = 0.5 * std::numbers::pi};
  }

  Vec3 moved(std::size_t node, double share) {
    return course.motions({&turn, 1}, share)[node](nodes.positions[node]);
  }

  static constexpr std::uint32_t cut = test::lobe_nodes + 2;
  NetworkNodes nodes = test::two_lobes();
  PieceTree tree;
  PieceTurn turn;
  TurnCourse course{nodes, tree};
};

TEST_F(TurnCourseTest, BeginsAtTheStart) {
  for (std::size_t k = 0; k < nodes.positions.size(); ++k)
    EXPECT_LT(distance(moved(k, 0.0), nodes.positions[k]), 1e-12) << k;
}

TEST_F(TurnCourseTest, APieceTurnsAsAWholeAndTheRestStays) {
  for (const double share : {0.3, 1.0}) {
    const double angle = share * turn.angle;
    for (std::size_t k = 0; k < cut - 4; ++k) EXPECT_EQ(moved(k, share), nodes.positions[k]) << k;
    for (std::size_t k = cut + 4; k < nodes.positions.size(); ++k) {
      const Vec3 r = nodes.positions[k] - turn.pivot;
      const Vec3 expected{std::cos(angle) * r.x - std::sin(angle) * r.y,
                          std::sin(angle) * r.x + std::cos(angle) * r.y, r.z};
      EXPECT_LT(distance(moved(k, share), turn.pivot + expected), 1e-11) << k;
    }
  }
}

/// About a pivot in the link neighbours stay about as far apart as they were.
TEST_F(TurnCourseTest, TheTurnIsSpreadBesideTheLink) {
  for (std::size_t k = 0; k + 1 < nodes.positions.size(); ++k)
    EXPECT_NEAR(distance(moved(k, 1.0), moved(k + 1, 1.0)),
                distance(nodes.positions[k], nodes.positions[k + 1]), 2.5)
        << k;
}

/// Above 180 degrees the nodes beside the link go the long way with their piece.
TEST_F(TurnCourseTest, TheLongWayRoundIsContinuous) {
  turn.angle = 1.4 * std::numbers::pi;
  constexpr int steps = 140;  // of 1.8 degrees
  for (std::size_t k = 0; k < nodes.positions.size(); ++k)
    for (int step = 0; step < steps; ++step) {
      const Vec3 now = moved(k, double(step) / steps), next = moved(k, double(step + 1) / steps);
      EXPECT_LT(distance(now, next), 0.8) << k << " " << step;
    }
}

}  // namespace
}  // namespace pliant
