// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/pieces.hpp"

#include <gtest/gtest.h>

#include "unit/sample/turns/two_lobes.hpp"

namespace pliant {
namespace {

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

}  // namespace
}  // namespace pliant
