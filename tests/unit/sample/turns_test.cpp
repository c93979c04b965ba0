// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/pieces.hpp"
#include "pliant/sample/turns/turn_course.hpp"
#include "pliant/sample/turns/turn_draws.hpp"
#include "support/test.hpp"
#include "unit/sample/two_lobes.hpp"

namespace pliant::turns_test {

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

  static constexpr std::uint32_t cut = test::lobe_nodes + 2, spread = 6;
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
    for (std::size_t k = 0; k < cut - spread; ++k)
      EXPECT_EQ(moved(k, share), nodes.positions[k]) << k;
    for (std::size_t k = cut + spread; k < nodes.positions.size(); ++k) {
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

TEST(Pieces, LobesAreParted) {
  const NetworkNodes nodes = test::two_lobes();
  const std::vector<PieceTree> trees = find_pieces(nodes, network_modes(nodes));
  ASSERT_FALSE(trees.empty());
  const PieceTree& tree = trees.front();
  EXPECT_EQ(tree.piece_count(), 2U);
  for (std::size_t k = 0; k < test::lobe_nodes; ++k) {
    EXPECT_EQ(tree.of_node[k], tree.of_node.front()) << k;
    EXPECT_EQ(tree.of_node[nodes.positions.size() - 1 - k], tree.of_node.back()) << k;
  }
  EXPECT_NE(tree.of_node.front(), tree.of_node.back());
  ASSERT_EQ(tree.links.size(), 1U);
  EXPECT_EQ(tree.links[0].after, tree.links[0].before + 1);
}

TEST(Pieces, TreesAreTrees) {
  const NetworkNodes nodes = test::two_lobes();
  for (const PieceTree& tree : find_pieces(nodes, network_modes(nodes))) {
    ASSERT_EQ(tree.of_node.size(), nodes.positions.size());
    std::vector<std::size_t> sizes(tree.piece_count(), 0);
    for (const std::uint32_t piece : tree.of_node) ++sizes.at(piece);
    EXPECT_EQ(tree.parent[0], -1);
    for (std::size_t p = 0; p < sizes.size(); ++p) {
      EXPECT_GE(sizes[p], least_piece(nodes.positions.size()));
      EXPECT_LE(sizes[p], sizes[0]);
      if (p > 0) EXPECT_LT(tree.parent[p], static_cast<std::int32_t>(p));
    }
  }
}

TEST(Pieces, OtherPlacesPartWhatMovedAsWholes) {
  const NetworkNodes nodes = test::two_lobes();
  std::vector<Vec3> other = nodes.positions;
  const std::size_t cut = test::lobe_nodes + test::strand_nodes / 2;
  const Vec3 pivot = other[cut];
  for (std::size_t k = cut; k < other.size(); ++k) {
    const Vec3 r = other[k] - pivot;
    other[k] = pivot + Vec3{-r.x, -r.y, r.z};  // by 180 degrees
  }
  const std::vector<PieceTree> trees = find_pieces(nodes, other);
  ASSERT_FALSE(trees.empty());
  EXPECT_EQ(trees.front().piece_count(), 2U);
  ASSERT_EQ(trees.front().links.size(), 1U);
  EXPECT_NEAR(double(trees.front().links[0].before), double(cut), 3.0);
}

TEST(Pieces, FewNodesHaveNone) {
  NetworkNodes nodes = test::two_lobes();
  nodes.positions.resize(9);
  nodes.chain.resize(9);
  EXPECT_TRUE(find_pieces(nodes, network_modes(nodes)).empty());
}

}  // namespace pliant::turns_test
