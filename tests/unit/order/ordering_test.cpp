// SPDX-License-Identifier: MIT
#include "pliant/order/ordering.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/order/ordering_file.hpp"
#include "support/test.hpp"

namespace pliant::ordering_test {

Ordering ordering_of(std::string_view name, const OrderRequest& context) {
  OrderScratch scratch;
  Ordering out;
  find_ordering(name).order(context, scratch, out);
  return out;
}

std::vector<BarIndex> bars_of(const Ordering& ordering) {
  std::vector<BarIndex> bars;
  for (const OrderedBar& visit : ordering) bars.push_back(visit.bar);
  return bars;
}

std::vector<BarIndex> ordered(std::string_view name, const Framework& framework,
                              std::int64_t sweep = 0, RandomKey key = {}) {
  return bars_of(ordering_of(name, {.framework = framework, .sweep = sweep, .key = key}));
}

TEST(Orderings, NamesAreUniqueAndSaidInErrors) {
  std::set<std::string_view> names;
  for (const OrderingEntry& row : orderings()) {
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_FALSE(row.summary.empty());
    EXPECT_EQ(&find_ordering(row.name), &row);
  }
  EXPECT_ERROR(OptionError,
               "no ordering named \"bsf_cycle\" (did you mean \"bfs_cycle\"?); known: random, "
               "bfs_tree, dfs_tree, bfs_cycle, dfs_cycle, bfs_reverse, dfs_reverse, bfs_adapt, "
               "bfs_random, input",
               find_ordering("bsf_cycle"));
}

TEST(InputOrdering, IsTheOrderOfTheBarsFromTheirFirstJoints) {
  const Framework framework = framework_of(ring(5));
  const Ordering out = ordering_of("input", {.framework = framework, .root = 3});
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
  std::map<std::vector<BarIndex>, int> counts;
  for (int k = 0; k < 24000; ++k) ++counts[ordered("random", framework, k)];
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
    const Joint root =
        ordering_of("bfs_random", {.framework = framework, .root = 4, .sweep = sweep}).front().near;
    EXPECT_TRUE(sweep > 0 || root == 4);
    roots.insert(root);
  }
  EXPECT_EQ(roots.size(), 9u);
}

/// Components that the root does not reach follow, each from its lowest joint.
TEST(Traversals, ReachEveryComponent) {
  FrameworkParts parts{.joint_count = 7, .bars = {{6, 5}, {1, 0}, {3, 4}, {2, 3}}};
  parts.rest_lengths.assign(4, 1.0);
  const Framework framework(std::move(parts));
  for (const char* name : {"bfs_tree", "dfs_tree", "bfs_cycle", "dfs_cycle"}) {
    const Ordering out = ordering_of(name, {.framework = framework, .root = 3});
    EXPECT_EQ(bars_of(out), (std::vector<BarIndex>{2, 3, 1, 0})) << name;
    EXPECT_EQ(out[0].near, 3u);
    EXPECT_EQ(out[2].near, 0u);
    EXPECT_EQ(out[3].near, 5u);
  }
}

/// Bars 0 - 1, 1 - 2, 2 - 0.
const Framework& triangle() {
  static const Framework framework = framework_of(ring(3));
  return framework;
}

TEST(CheckOrdering, NamesWhatIsWrong) {
  const std::pair<const char*, Ordering> cases[] = {
      {"", {{0, 0, true}, {1, 1, true}, {2, 0, false}}},
      {"bar 3 unknown", {{0, 0, true}, {3, 1, true}}},
      {"bar 0 - 1 appears twice", {{0, 0, true}, {0, 1, true}}},
      {"bar 0 - 1 has a near joint that is not its end", {{0, 2, true}}},
      {"tree bar 2 - 0 closes a cycle", {{0, 0, true}, {1, 1, true}, {2, 0, true}}},
      {"bar 1 - 2 is missing", {{0, 0, true}, {2, 0, true}}}};
  for (const auto& [fault, ordering] : cases)
    EXPECT_EQ(check_ordering(triangle(), ordering), fault);
}

TEST(CheckOrdering, HoldsTheOrderingToItsPromisesOnly) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {2, 0, true}}, {.all_bars = false}), "");
  EXPECT_EQ(
      check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, true}}, {.tree_bars = false}),
      "");
}

/// Of the joints 0, 1 and 2; tests/corpus/ordering holds what is read and refused.
TEST(OrderingFile, IndicesAreBelowTheNumberOfJoints) {
  EXPECT_ERROR(InputError, "o.txt:2: joint: no joint is named \"3\"",
               parse_ordering_file({"o.txt", "pliant-ordering 1\nbar 3 0 tree"}, triangle()));
}

TEST(OrderingFile, IsWrittenOnlyIfItCouldBeRead) {
  const auto error = [](const Ordering& ordering) {
    return test::error_text<InputError>([&] { write_ordering_file(ordering, triangle()); });
  };
  EXPECT_EQ(error({{0, 0, true}}), "ordering file: bar 1 - 2 is missing");
  EXPECT_EQ(error({{0, 2, true}}), "ordering file: bar 0 - 1 has a near joint that is not its end");
  EXPECT_EQ(error({{7, 0, true}}), "ordering file: bar 7 unknown");
}

TEST(ReadOrderingFile, ReadsFilesAndNamesThemInErrors) {
  const test::TempDirectory directory;
  const std::filesystem::path path = directory / "ordering.txt";
  const std::string text = "pliant-ordering 1\nbar 2 1 tree\nbar 2 0 tree\nbar 1 0 non_tree\n";
  std::ofstream(path) << "\xef\xbb\xbf" << text;
  EXPECT_EQ(write_ordering_file(read_ordering_file(path, triangle()), triangle()), text);
  std::ofstream(path) << "nothing";
  EXPECT_ERROR(InputError, path.string() + ":1: expected \"pliant-ordering 1\", found \"nothing\"",
               read_ordering_file(path, triangle()));
  std::filesystem::remove(path);
  EXPECT_THROW(read_ordering_file(path, triangle()), FileError);
}

}  // namespace pliant::ordering_test
