// SPDX-License-Identifier: MIT
#include "pliant/order/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace ordering_test {

std::vector<BarIndex> bars_of(const Ordering& ordering) {
  std::vector<BarIndex> bars;
  for (const OrderedBar& visit : ordering) bars.push_back(visit.bar);
  return bars;
}

std::vector<BarIndex> ordered(std::string_view name, const Framework& framework,
                              std::int64_t sweep = 0, RandomKey key = {}) {
  OrderScratch scratch;
  Ordering out;
  find_ordering(name).order({.framework = framework, .sweep = sweep, .key = key}, scratch, out);
  return bars_of(out);
}

TEST(Orderings, NamesAreUniqueAndSaidInErrors) {
  std::set<std::string_view> names;
  for (const OrderingEntry& row : orderings()) {
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_FALSE(row.summary.empty());
    EXPECT_EQ(&find_ordering(row.name), &row);
  }
  EXPECT_EQ(test::error_text<OptionError>([] { find_ordering("bsf_cycle"); }),
            "no ordering named \"bsf_cycle\" (did you mean \"bfs_cycle\"?); known: random, "
            "bfs_tree, dfs_tree, bfs_cycle, dfs_cycle, bfs_reverse, dfs_reverse, bfs_adapt, "
            "bfs_random, input");
}

TEST(InputOrdering, IsTheOrderOfTheBarsFromTheirFirstJoints) {
  const Framework framework = framework_of(ring(5));
  OrderScratch scratch;
  Ordering out;
  find_ordering("input").order({.framework = framework, .root = 3}, scratch, out);
  ASSERT_EQ(out.size(), 5u);
  for (BarIndex k = 0; k < 5; ++k) {
    EXPECT_EQ(out[k].bar, k);
    EXPECT_EQ(out[k].near, framework.bars()[k].a);
    EXPECT_TRUE(out[k].is_tree);
  }
}

TEST(RandomOrdering, IsShuffledAgainForEachSweepStepWalkerAndSeed) {
  const Framework framework = framework_of(grid(5, 5));
  std::set<std::vector<BarIndex>> seen;
  seen.insert(ordered("random", framework));
  seen.insert(ordered("random", framework, 1));
  seen.insert(ordered("random", framework, 0, {.seed = 1}));
  seen.insert(ordered("random", framework, 0, {.walker = 1}));
  seen.insert(ordered("random", framework, 0, {.step = 1}));
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(ordered("random", framework, 1), ordered("random", framework, 1));
}

/// All 24 orders of four bars, each about as often: chi squared of 23 degrees of freedom is below
/// 55 but once in 5000.
TEST(RandomOrdering, GivesEachPermutationItsShare) {
  const Framework framework = framework_of(star(4));
  std::vector<std::pair<std::vector<BarIndex>, int>> counts;
  constexpr int shuffles = 24000;
  for (int k = 0; k < shuffles; ++k) {
    const auto order = ordered("random", framework, k);
    auto at = std::find_if(counts.begin(), counts.end(),
                           [&](const auto& entry) { return entry.first == order; });
    if (at == counts.end()) at = counts.insert(at, {order, 0});
    ++at->second;
  }
  ASSERT_EQ(counts.size(), 24u);
  double chi_squared = 0.0;
  for (const auto& [order, count] : counts)
    chi_squared += (count - 1000.0) * (count - 1000.0) / 1000.0;
  EXPECT_LT(chi_squared, 55.0);
}

TEST(BfsRandom, BeginsAtTheRootAndThenAnywhere) {
  const Framework framework = framework_of(ring(9));
  std::set<Joint> roots;
  for (std::int64_t sweep = 0; sweep < 60; ++sweep) {
    OrderScratch scratch;
    Ordering out;
    find_ordering("bfs_random")
        .order({.framework = framework, .root = 4, .sweep = sweep}, scratch, out);
    EXPECT_TRUE(sweep > 0 || out.front().near == 4);
    roots.insert(out.front().near);
  }
  EXPECT_EQ(roots.size(), 9u);
}

/// Components that the root does not reach follow, each from its lowest joint.
TEST(Traversals, ReachEveryComponent) {
  FrameworkParts parts;
  parts.joint_count = 7;
  parts.bars = {{6, 5}, {1, 0}, {3, 4}, {2, 3}};
  parts.rest_lengths.assign(4, 1.0);
  const Framework framework(std::move(parts));
  for (const char* name : {"bfs_tree", "dfs_tree", "bfs_cycle", "dfs_cycle"}) {
    OrderScratch scratch;
    Ordering out;
    find_ordering(name).order({.framework = framework, .root = 3}, scratch, out);
    EXPECT_EQ(bars_of(out), (std::vector<BarIndex>{2, 3, 1, 0})) << name;
    EXPECT_EQ(out[0].near, 3u);
    EXPECT_EQ(out[2].near, 0u);
    EXPECT_EQ(out[3].near, 5u);
  }
}

}  // namespace ordering_test
}  // namespace pliant
