// SPDX-License-Identifier: MIT
// Components and blocks of graphs, and those of frameworks; things in groups.
#include "pliant/framework/graph.hpp"

#include <rapidcheck/gtest.h>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/base/graphs/grouped.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/random_frameworks.hpp"
#include "support/test.hpp"

namespace pliant::graph_test {

using Slotted = std::pair<std::size_t, int>;

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

/// Sets by the plainest union-find there is.
class Sets {
 public:
  explicit Sets(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0u); }
  void join(std::size_t a, std::size_t b) {
    const std::size_t from = of_[a], to = of_[b];
    for (std::size_t& set : of_)
      if (set == from) set = to;
  }
  bool together(std::size_t a, std::size_t b) const { return of_[a] == of_[b]; }
  std::size_t count() const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < of_.size(); ++i)
      found += std::find(of_.begin(), of_.begin() + long(i), of_[i]) == of_.begin() + long(i);
    return found;
  }

 private:
  std::vector<std::size_t> of_;
};

/// Joints connected by the bars that `keep` keeps.
template <class Keep>
Sets connected(const Framework& framework, Keep keep) {
  Sets sets(framework.joint_count());
  for (std::size_t k = 0; k < framework.bar_count(); ++k)
    if (keep(k)) sets.join(framework.bars()[k].a, framework.bars()[k].b);
  return sets;
}

RC_GTEST_PROP(Graph, ComponentsAreThoseOfUnionFind, ()) {
  const Framework framework = test::any_framework(12, 20).framework;
  const Components found = find_components(framework);
  const Sets expected = connected(framework, [](auto) { return true; });
  RC_ASSERT(found.count == expected.count());
  for (std::size_t i = 0; i < framework.joint_count(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      RC_ASSERT((found.of_node[i] == found.of_node[j]) == expected.together(i, j));
  for (std::size_t c = 0; c < found.count; ++c) {
    RC_ASSERT(found.of_node[found.lowest_node[c]] == c);
    // In brackets: RC_ASSERT takes a bare || apart and evaluates both sides.
    RC_ASSERT((c == 0 || found.lowest_node[c] > found.lowest_node[c - 1]));
    for (std::size_t i = 0; i < found.lowest_node[c]; ++i) RC_ASSERT(found.of_node[i] != c);
  }
}

/// A bridge is a bar whose loss parts its two joints.
RC_GTEST_PROP(Graph, BridgesPartTheirJoints, ()) {
  const Framework framework = test::any_framework(10, 16).framework;
  const Blocks found = find_blocks(framework);
  std::size_t bridges = 0;
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    const Sets without = connected(framework, [&](std::size_t other) { return other != k; });
    const bool is_bridge = !without.together(framework.bars()[k].a, framework.bars()[k].b);
    RC_ASSERT(found.is_bridge[k] == is_bridge);
    bridges += is_bridge;
  }
  RC_ASSERT(found.bridge_count == bridges);
}

/// Two bars at a joint are in one block if their other ends are connected without that joint;
/// blocks are what that relation generates.
RC_GTEST_PROP(Graph, BlocksAreWhatCyclesGenerate, ()) {
  const Framework framework = test::any_framework(10, 16).framework;
  const auto bars = framework.bars();
  Sets expected(bars.size());
  for (Joint v = 0; v < framework.joint_count(); ++v) {
    const Sets without =
        connected(framework, [&](std::size_t k) { return bars[k].a != v && bars[k].b != v; });
    for (const Incidence& one : framework.neighbours(v))
      for (const Incidence& two : framework.neighbours(v))
        if (without.together(one.joint, two.joint)) expected.join(one.bar, two.bar);
  }
  const Blocks found = find_blocks(framework);
  RC_ASSERT(found.count == expected.count());
  std::vector<std::size_t> sizes(found.count, 0);
  for (std::size_t k = 0; k < bars.size(); ++k) {
    ++sizes[found.of_edge[k]];
    for (std::size_t j = 0; j < k; ++j)
      RC_ASSERT((found.of_edge[k] == found.of_edge[j]) == expected.together(k, j));
  }
  RC_ASSERT(found.largest == (sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end())));
}

GraphFacts facts_of(const Sketch& sketch) { return graph_facts(framework_of(sketch)); }

/// Two rings of 5 and 7 joined by a path of three bars.
TEST(GraphFacts, OfRingsOnAPathAreTwoBlocks) {
  Sketch sketch = ring(5);
  const Sketch other = ring(7);
  for (Vec3 x : other.positions) sketch.positions.push_back(x + Vec3{9, 0, 0});
  for (Bar bar : other.bars) sketch.bars.push_back({bar.a + 5, bar.b + 5});
  sketch.positions.insert(sketch.positions.end(), {{3, 0, 1}, {5, 0, 1}});
  sketch.bars.insert(sketch.bars.end(), {{0, 12}, {12, 13}, {13, 8}});
  const GraphFacts facts = facts_of(sketch);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.cycles, 2u);
  EXPECT_EQ(facts.bridges, 3u);
  EXPECT_EQ(facts.blocks, 2u);
  EXPECT_EQ(facts.largest_block, 7u);
  EXPECT_EQ(facts.bars_in_blocks, 12u);
  EXPECT_FALSE(facts.is_forest());
}

TEST(GraphFacts, OfNothingAreZero) {
  const GraphFacts facts = facts_of({});
  EXPECT_EQ(facts.components, 0u);
  EXPECT_EQ(facts.cycles, 0u);
  EXPECT_TRUE(facts.is_forest());
  EXPECT_TRUE(facts_of(star(9)).is_forest());
}

std::vector<int> list(std::span<const int> things) { return {things.begin(), things.end()}; }

RC_GTEST_PROP(Grouped, HasTheThingsOfEachSlotInTheirOrder, ()) {
  const auto slots = *rc::gen::inRange<std::size_t>(1, 8);
  const auto all = *rc::gen::container<std::vector<Slotted>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, slots), rc::gen::arbitrary<int>()));
  const Grouped<int> grouped(slots, [&](const auto& put) {
    for (const auto& [slot, thing] : all) put(slot, thing);
  });
  std::vector<std::vector<int>> expected(slots);
  for (const auto& [slot, thing] : all) expected[slot].push_back(thing);
  RC_ASSERT(grouped.size() == slots);
  RC_ASSERT(grouped.things().size() == all.size());
  Grouped<int, std::size_t> added;
  for (std::size_t k = 0; k < slots; ++k) {
    RC_ASSERT(list(grouped.at(k)) == expected[k]);
    RC_ASSERT(grouped.at(k).data() == grouped.things().data() + grouped.begin_of(k));
    added.add(expected[k]);
    RC_ASSERT(list(added.at(k)) == expected[k]);
  }
  RC_ASSERT(added.size() == slots);
}

TEST(Grouped, BeginsWithoutSlots) {
  EXPECT_EQ(Grouped<int>().size(), 0u);
  EXPECT_TRUE(Grouped<int>().things().empty());
  const Grouped<int> none(0, [](const auto&) {});
  EXPECT_EQ(none.size(), 0u);
}

TEST(Grouped, GivesThingsToChange) {
  Grouped<int> grouped;
  grouped.add(std::vector<int>{1, 2});
  grouped.add(std::vector<int>{3});
  for (int& thing : grouped.at(0)) thing *= 10;
  for (int& thing : grouped.things()) ++thing;
  EXPECT_EQ(list(std::as_const(grouped).things()), (std::vector<int>{11, 21, 4}));
}

}  // namespace pliant::graph_test
