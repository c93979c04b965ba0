// SPDX-License-Identifier: MIT
#include "pliant/order/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "pliant/base/error.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/order/ordering_file.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant::ordering_test {

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

/// Bars 0 - 1, 1 - 2, 2 - 0.
const Framework& triangle() {
  static const Framework framework = framework_of(ring(3));
  return framework;
}

TEST(CheckOrdering, AcceptsATreeAndItsNonTreeBar) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, false}}), "");
}

TEST(CheckOrdering, NamesWhatIsWrong) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {3, 1, true}}), "bar 3 unknown");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {0, 1, true}}), "bar 0 - 1 appears twice");
  EXPECT_EQ(check_ordering(triangle(), {{0, 2, true}}),
            "bar 0 - 1 has a near joint that is not its end");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, true}}),
            "tree bar 2 - 0 closes a cycle");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {2, 0, true}}), "bar 1 - 2 is missing");
}

TEST(CheckOrdering, HoldsTheOrderingToItsPromisesOnly) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {2, 0, true}}, {.all_bars = false}), "");
  EXPECT_EQ(
      check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, true}}, {.tree_bars = false}),
      "");
}

/// Joints a, b, c, d; bars ab, bc, ca, cd.
const Framework& kite() {
  static const Framework framework = [] {
    AtomTable atoms;
    atoms.residues = {{"", 1, ' ', ""}};
    for (const char* name : {"a", "b", "c", "d"}) {
      atoms.names.emplace_back(name);
      atoms.elements.push_back(0);
      atoms.residue_of.push_back(0);
      atoms.serials.push_back(std::int64_t(atoms.names.size()));
    }
    FrameworkParts parts;
    parts.joint_count = 4;
    parts.bars = {{0, 1}, {1, 2}, {2, 0}, {2, 3}};
    parts.rest_lengths = {1, 1, 1, 1};
    parts.atoms = std::make_shared<AtomTable>(std::move(atoms));
    return Framework(std::move(parts));
  }();
  return framework;
}

Ordering parse(std::string_view text, const Framework& framework = kite()) {
  return parse_ordering_file({"o.txt", text}, framework);
}

std::string refusal(std::string_view lines) {
  return test::error_text<InputError>([&] { parse("pliant-ordering 1\n" + std::string(lines)); });
}

constexpr std::string_view plain =
    "pliant-ordering 1\n"
    "# from c\n"
    "bar c b tree\n"
    "bar c a tree      # the far end is a\n"
    "\n"
    "bar c d tree\n"
    "bar b a non_tree";

void expect_plain(const Ordering& ordering) {
  ASSERT_EQ(ordering.size(), 4u);
  const Ordering expected{{1, 2, true}, {2, 2, true}, {3, 2, true}, {0, 1, false}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(ordering[k].bar, expected[k].bar);
    EXPECT_EQ(ordering[k].near, expected[k].near);
    EXPECT_EQ(ordering[k].is_tree, expected[k].is_tree);
  }
}

TEST(OrderingFile, ReadsBarsFromTheirNearJoints) { expect_plain(parse(plain)); }

TEST(OrderingFile, TakesCarriageReturnsAndIndices) {
  std::string text;
  for (char c : plain) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_plain(parse(text));
  expect_plain(
      parse("pliant-ordering 1\nbar 2 1 tree\nbar 2 0 tree\nbar c 3 tree\nbar 1 0 non_tree\n"));
}

TEST(OrderingFile, IsReadBackToTheSameVisits) {
  const std::string text = write_ordering_file(parse(plain), kite());
  EXPECT_EQ(text,
            "pliant-ordering 1\nbar c b tree\nbar c a tree\nbar c d tree\nbar b a non_tree\n");
  expect_plain(parse(text));
}

TEST(OrderingFile, SaysWhatItExpectedFirst) {
  const auto error = [](std::string_view text) {
    return test::error_text<InputError>([&] { parse(text); });
  };
  EXPECT_EQ(error(""), "o.txt: expected the line \"pliant-ordering 1\" first, found no text");
  EXPECT_EQ(error("\npliant-ordering 2"),
            "o.txt:2: expected \"pliant-ordering 1\", found \"pliant-ordering 2\"");
  EXPECT_EQ(error("pliant-forces 1\x1b[2J"),
            "o.txt:1: expected \"pliant-ordering 1\", found \"pliant-forces 1\\x1b[2J\"");
}

TEST(OrderingFile, NamesTheFieldThatIsWrong) {
  EXPECT_EQ(refusal("bar a zz tree"), "o.txt:2: joint: no joint is named \"zz\"");
  EXPECT_EQ(refusal("bar 4 a tree"), "o.txt:2: joint: no joint is named \"4\"");
  EXPECT_EQ(refusal("bar a d tree"), "o.txt:2: bar \"a\" - \"d\": the framework has no such bar");
  EXPECT_EQ(refusal("bar a a tree"), "o.txt:2: bar \"a\" - \"a\": the framework has no such bar");
  EXPECT_EQ(refusal("bar a b twig"), "o.txt:2: kind: expected tree or non_tree, found \"twig\"");
  EXPECT_EQ(refusal("bar a b"),
            "o.txt:2: bar: expected near joint, far joint and kind (tree or non_tree), found 2 "
            "fields");
  EXPECT_EQ(refusal("rod a b tree"), "o.txt:2: expected bar, found \"rod\"");
}

TEST(OrderingFile, WantsEachBarOnce) {
  EXPECT_EQ(refusal("bar a b tree\n\nbar b a tree"),
            "o.txt:4: bar \"b\" - \"a\" is given twice, first in line 2");
  EXPECT_EQ(refusal("bar a b tree\nbar c d tree\nbar c a non_tree"),
            "o.txt: bar b - c is missing: expected 4 bars, found 3");
}

TEST(OrderingFile, IsWrittenOnlyIfItCouldBeRead) {
  const auto error = [](const Ordering& ordering) {
    return test::error_text<InputError>([&] { write_ordering_file(ordering, kite()); });
  };
  EXPECT_EQ(error({{0, 0, true}}), "ordering file: bar b - c is missing");
  EXPECT_EQ(error({{0, 3, true}}), "ordering file: bar a - b has a near joint that is not its end");
  EXPECT_EQ(error({{7, 0, true}}), "ordering file: bar 7 unknown");
}

TEST(ReadOrderingFile, ReadsFilesAndNamesThemInErrors) {
  const test::TempDirectory directory;
  const std::filesystem::path path = directory / "ordering.txt";
  std::ofstream(path) << "\xef\xbb\xbf" << plain;
  expect_plain(read_ordering_file(path, kite()));
  std::ofstream(path) << "nothing";
  EXPECT_EQ(test::error_text<InputError>([&] { read_ordering_file(path, kite()); }),
            path.string() + ":1: expected \"pliant-ordering 1\", found \"nothing\"");
  std::filesystem::remove(path);
  EXPECT_THROW(read_ordering_file(path, kite()), FileError);
}

}  // namespace pliant::ordering_test
