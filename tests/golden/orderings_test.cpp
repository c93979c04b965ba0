// SPDX-License-Identifier: MIT
// The orderings that the thesis "Motion Simulation of Geometric Constraint Structures" prints.
#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/order/ordering_file.hpp"
#include "support/test.hpp"

namespace pliant::orderings_test {

/// "ab bc *ca": a letter a joint from its near end as far as the bar is a tree bar, ends of
/// non-tree bars in alphabetical order after a star.
std::string printed(const Framework& framework, const Ordering& ordering) {
  std::string text;
  for (const OrderedBar& visit : ordering) {
    const Bar bar = framework.bars()[visit.bar];
    const auto [low, high] = std::minmax(bar.a, bar.b);
    const Joint first = visit.is_tree ? visit.near : low;
    const Joint second = first == bar.a ? bar.b : bar.a;
    if (!text.empty()) text += ' ';
    if (!visit.is_tree) text += '*';
    text += {static_cast<char>('a' + first), static_cast<char>('a' + second)};
    EXPECT_TRUE(visit.is_tree || second == high);
  }
  return text;
}

/// The ordering of the first sweep from joint a.
std::string first_sweep(std::string_view figure, std::string_view ordering) {
  const Example& example = find_example(figure);
  OrderScratch scratch;
  Ordering out;
  find_ordering(ordering).order({.framework = example.framework, .positions = example.positions},
                                scratch, out);
  return printed(example.framework, out);
}

TEST(PrintedOrderings, Figure2_2) {
  EXPECT_EQ(first_sweep("thesis_figure_2_2", "bfs_tree"), "ab ac bd ce");
  EXPECT_EQ(first_sweep("thesis_figure_2_2", "dfs_tree"), "ab bd de ec");
}

TEST(PrintedOrderings, Figure5_2) {
  EXPECT_EQ(first_sweep("thesis_figure_5_2", "bfs_cycle"), "ab ac af bd ce fg *de *eg");
  EXPECT_EQ(first_sweep("thesis_figure_5_2", "dfs_cycle"), "ab bd de ec *ac eg gf *af");
}

// Backwards is the resolver's part: Repeat::reverse says so.
TEST(PrintedOrderings, Figure5_5) {
  EXPECT_EQ(first_sweep("thesis_figure_5_5", "bfs_reverse"), "ab ac bd *bc");
  EXPECT_EQ(first_sweep("thesis_figure_5_5", "dfs_reverse"), "ab bd bc *ac");
  EXPECT_EQ(find_ordering("bfs_reverse").repeat, Repeat::reverse);
  EXPECT_EQ(find_ordering("dfs_reverse").repeat, Repeat::reverse);
}

TEST(PrintedOrderings, Figure5_8) {
  EXPECT_EQ(first_sweep("thesis_figure_5_5", "bfs_adapt"), "ab ac bd *bc");
}

TEST(PrintedOrderings, Figure5_10) {
  EXPECT_EQ(first_sweep("thesis_figure_5_10", "bfs_random"), "ab ac bd *bc df *cd fe");
}

/// Later sweeps of bfs_adapt begin at the non-tree bar, at the end that was taken first.
TEST(PrintedOrderings, BfsAdaptBeginsAgainAtTheNonTreeBar) {
  const Example& example = find_example("thesis_figure_5_5");
  const OrderingEntry& entry = find_ordering("bfs_adapt");
  OrderScratch scratch;
  Ordering first, second;
  const std::vector<Vec3>& positions = example.positions;
  entry.order({.framework = example.framework, .positions = positions}, scratch, first);
  entry.order(
      {.framework = example.framework, .sweep = 1, .positions = positions, .before = &first},
      scratch, second);
  EXPECT_EQ(printed(example.framework, second), "ba bd bc *ac");
}

/// Of two non-tree bars the one that is further off is the next root.
TEST(PrintedOrderings, BfsAdaptTakesTheWorstNonTreeBar) {
  const Example& example = find_example("thesis_figure_5_10");
  const OrderingEntry& entry = find_ordering("bfs_adapt");
  OrderScratch scratch;
  Ordering first, second;
  std::vector<Vec3> positions = example.positions;
  positions[3] += Vec3{0, -1, 0};  // d: breaks bd, df and the non-tree bar cd, but not bc
  entry.order({.framework = example.framework, .positions = positions}, scratch, first);
  entry.order(
      {.framework = example.framework, .sweep = 1, .positions = positions, .before = &first},
      scratch, second);
  EXPECT_EQ(printed(example.framework, second), "ca cb cd *ab df *bd fe");
}

/// As a file and back: the same bars, near joints and stars.
TEST(PrintedOrderings, SurviveAnOrderingFile) {
  const std::pair<const char*, const char*> printed_whole[] = {
      {"thesis_figure_5_2", "bfs_cycle"},   {"thesis_figure_5_2", "dfs_cycle"},
      {"thesis_figure_5_5", "bfs_reverse"}, {"thesis_figure_5_5", "dfs_reverse"},
      {"thesis_figure_5_5", "bfs_adapt"},   {"thesis_figure_5_10", "bfs_random"},
      {"thesis_figure_3_5", "bfs_tree"},    {"thesis_figure_3_5", "dfs_tree"}};
  for (const auto& [figure, name] : printed_whole) {
    const Framework& framework = find_example(figure).framework;
    OrderScratch scratch;
    Ordering ordering;
    find_ordering(name).order({.framework = framework}, scratch, ordering);
    const std::string text = write_ordering_file(ordering, framework);
    const Ordering back = parse_ordering_file({"o.txt", text}, framework);
    EXPECT_EQ(printed(framework, back), first_sweep(figure, name));
    EXPECT_EQ(write_ordering_file(back, framework), text);
  }
}

TEST(PrintedOrderings, Figure5_2AsAFile) {
  const Framework& framework = find_example("thesis_figure_5_2").framework;
  const Ordering stated = parse_ordering_file(
      {"figure 5.2",
       "pliant-ordering 1\nbar 0 1 tree\nbar 0 2 tree\nbar 0 5 tree\nbar 1 3 tree\n"
       "bar 2 4 tree\nbar 5 6 tree\nbar 3 4 non_tree\nbar 4 6 non_tree\n"},
      framework);
  EXPECT_EQ(printed(framework, stated), "ab ac af bd ce fg *de *eg");
}

}  // namespace pliant::orderings_test
