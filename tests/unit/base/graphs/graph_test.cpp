// SPDX-License-Identifier: MIT
// What components and blocks are is tested on frameworks: tests/unit/framework/graph_test.cpp.
#include "pliant/base/graphs/graph.hpp"

#include <gtest/gtest.h>

#include "pliant/framework/graph.hpp"
#include "support/random_frameworks.hpp"

#include <rapidcheck/gtest.h>

namespace pliant {
namespace graph_test {

/// A triangle 1-2-3 with an edge to 4, two edges between 5 and 6, and nothing at 0.
Graph sample() {
  return {7, std::vector<Graph::Edge>{{3, 1}, {1, 2}, {2, 3}, {3, 4}, {5, 6}, {6, 5}}};
}

TEST(BaseGraph, HasTheLinksOfANodeInTheOrderOfTheEdges) {
  const Graph graph = sample();
  EXPECT_EQ(graph.node_count(), 7u);
  EXPECT_EQ(graph.edge_count(), 6u);
  EXPECT_TRUE(graph.at(0).empty());
  std::vector<std::uint32_t> nodes, edges;
  for (const Link& link : graph.at(3)) {
    nodes.push_back(link.node);
    edges.push_back(link.edge);
  }
  EXPECT_EQ(nodes, (std::vector<std::uint32_t>{1, 2, 4}));
  EXPECT_EQ(edges, (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(BaseGraph, NumbersComponentsByTheirLowestNode) {
  const Components found = find_components(sample());
  EXPECT_EQ(found.count, 3u);
  EXPECT_EQ(found.of_node, (std::vector<std::uint32_t>{0, 1, 1, 1, 1, 2, 2}));
  EXPECT_EQ(found.lowest_node, (std::vector<std::uint32_t>{0, 1, 5}));
}

/// Frameworks have no parallel bars; a graph may have parallel edges, and they are a cycle.
TEST(BaseGraph, ParallelEdgesAreABlock) {
  const Blocks found = find_blocks(sample());
  EXPECT_EQ(found.is_bridge, (std::vector<bool>{false, false, false, true, false, false}));
  EXPECT_EQ(found.count, 3u);
  EXPECT_EQ(found.largest, 3u);
  EXPECT_EQ(found.of_edge[0], found.of_edge[2]);
  EXPECT_EQ(found.of_edge[4], found.of_edge[5]);
}

TEST(BaseGraph, WithoutNodesHasNothing) {
  EXPECT_EQ(Graph().node_count(), 0u);
  EXPECT_EQ(find_components(Graph()).count, 0u);
  EXPECT_EQ(find_blocks(Graph()).count, 0u);
}

RC_GTEST_PROP(BaseGraph, OfAFrameworkIsItsBars, ()) {
  const Framework framework = test::any_framework(12, 20).framework;
  const Graph graph(framework.joint_count(), framework.bars());
  RC_ASSERT(graph.edge_count() == framework.bar_count());
  for (Joint joint = 0; joint < framework.joint_count(); ++joint) {
    const auto here = framework.neighbours(joint);
    RC_ASSERT(graph.at(joint).size() == here.size());
    for (std::size_t k = 0; k < here.size(); ++k) {
      RC_ASSERT(graph.at(joint)[k].node == here[k].joint);
      RC_ASSERT(graph.at(joint)[k].edge == here[k].bar);
    }
  }
  RC_ASSERT(find_blocks(graph).of_edge == find_blocks(framework).of_edge);
  RC_ASSERT(find_components(graph).of_node == find_components(framework).of_node);
}

}  // namespace graph_test
}  // namespace pliant
