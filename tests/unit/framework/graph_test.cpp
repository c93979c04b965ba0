// SPDX-License-Identifier: MIT
#include "pliant/framework/graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "pliant/lab/examples/examples.hpp"
#include "support/random_frameworks.hpp"

namespace pliant {
namespace graph_test {

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

TEST(GraphFacts, OfATreeAreBridgesOnly) {
  const GraphFacts facts = facts_of(star(9));
  EXPECT_EQ(facts.joints, 10u);
  EXPECT_EQ(facts.bars, 9u);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.cycles, 0u);
  EXPECT_EQ(facts.bridges, 9u);
  EXPECT_EQ(facts.blocks, 0u);
  EXPECT_EQ(facts.largest_block, 0u);
  EXPECT_EQ(facts.bars_in_blocks, 0u);
  EXPECT_TRUE(facts.is_forest());
}

TEST(GraphFacts, OfAGridAreCells) {
  const GraphFacts facts = facts_of(grid(4, 6));
  EXPECT_EQ(facts.cycles, 24u);
  EXPECT_EQ(facts.blocks, 1u);
  EXPECT_EQ(facts.largest_block, facts.bars);
  EXPECT_FALSE(facts.is_forest());
}

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
}

TEST(GraphFacts, OfNothingAreZero) {
  const GraphFacts facts = facts_of({});
  EXPECT_EQ(facts.components, 0u);
  EXPECT_EQ(facts.cycles, 0u);
  EXPECT_TRUE(facts.is_forest());
}

}  // namespace graph_test
}  // namespace pliant
