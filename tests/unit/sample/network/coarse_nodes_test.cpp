// SPDX-License-Identifier: MIT
#include "pliant/sample/network/coarse_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pliant {
namespace coarse_nodes_test {

/// A straight chain of nodes 3.8 Angstrom apart, and lone ones on a cubic grid of 2 Angstrom.
NetworkNodes chain_and_grid(std::size_t length, int side) {
  NetworkNodes nodes;
  for (std::size_t k = 0; k < length; ++k) {
    nodes.positions.push_back({3.8 * double(k), 0.0, -40.0});
    nodes.chain.push_back(0);
  }
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        nodes.positions.push_back({2.0 * x, 2.0 * y, 2.0 * z});
        nodes.chain.push_back(static_cast<std::uint32_t>(nodes.chain.size()));
      }
  for (std::size_t k = 0; k < nodes.chain.size(); ++k)
    nodes.of_joint.push_back(static_cast<std::uint32_t>(k));
  nodes.of_joint.push_back(no_node);
  return nodes;
}

TEST(CoarseNodes, FewStayAsTheyAre) {
  const NetworkNodes nodes = coarsened(chain_and_grid(10, 1), 11);
  EXPECT_EQ(nodes.positions.size(), 11U);
  EXPECT_EQ(nodes.scale, 1.0);
}

TEST(CoarseNodes, ThoseOfAChainAreMergedAtTheirMeanAndSpringsGrow) {
  const NetworkNodes nodes = coarsened(chain_and_grid(16, 0), 2);
  ASSERT_EQ(nodes.positions.size(), 2U);
  EXPECT_NEAR(nodes.positions[0].x, 3.8 * 3.5, 1e-9);
  EXPECT_NEAR(nodes.positions[1].x, 3.8 * 11.5, 1e-9);
  EXPECT_NEAR(nodes.scale, 2.0, 1e-9);
  EXPECT_EQ(nodes.of_joint[7], 0U);
  EXPECT_EQ(nodes.of_joint[8], 1U);
  EXPECT_EQ(nodes.of_joint[16], no_node);
}

TEST(CoarseNodes, ThousandsOfLoneAtomsBecomeAFewEachNear) {
  const NetworkNodes before = chain_and_grid(200, 16);
  const NetworkNodes nodes = coarsened(before, 200);
  EXPECT_LE(nodes.positions.size(), 200U);
  EXPECT_EQ(nodes.of_joint.size(), before.of_joint.size());
  check(nodes, before.of_joint.size());
  double furthest = 0.0;
  for (std::size_t k = 200; k < before.positions.size(); ++k)
    furthest =
        std::max(furthest, distance(before.positions[k], nodes.positions[nodes.of_joint[k]]));
  EXPECT_LT(furthest, 12.4);  // half of the diagonal of a cell of 5.1 cbrt(22) Angstrom
  for (std::size_t k = 1; k < nodes.chain.size(); ++k)
    EXPECT_EQ(nodes.chain[k] != nodes.chain[k - 1], nodes.chain[k] != 0);
}

}  // namespace coarse_nodes_test
}  // namespace pliant
