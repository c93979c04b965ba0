// SPDX-License-Identifier: MIT
// What every ordering promises, for every row of orderings() on every example; and what is
// generated, written and read again is the same, for every class of graphs: the graph, every
// ordering of it, and its forces; a run from the files is the run from memory.
#include "pliant/lab/examples/examples.hpp"
#include "pliant/lab/generate/random_graphs.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant {

void PrintTo(const OrderingEntry& row, std::ostream* out) { *out << row.name; }
void PrintTo(const GraphClass& row, std::ostream* out) { *out << row.name; }

}  // namespace pliant

namespace pliant::order_law_test {

class OrderLaw : public testing::TestWithParam<OrderingEntry> {};

std::string name_of(const testing::TestParamInfo<OrderingEntry>& row) {
  return std::string(row.param.name);
}

/// Calls `look(sweep, ordering)` for the first sweeps of a resolve.
template <class Look>
void each_sweep(const OrderingEntry& entry, const Framework& framework,
                std::span<const Vec3> positions, Joint root, Look look) {
  OrderScratch scratch;
  Ordering before, now;
  for (std::int64_t sweep = 0; sweep < 4; ++sweep) {
    entry.order({framework, root, sweep, {.seed = 7}, positions, sweep > 0 ? &before : nullptr},
                scratch, now);
    look(sweep, now);
    before.swap(now);
  }
}

std::vector<Joint> roots_of(const Framework& framework) {
  const std::size_t count = framework.joint_count();
  if (count == 0) return {0};
  return {0, static_cast<Joint>(count / 2), static_cast<Joint>(count - 1)};
}

/// Each bar once in each sweep; tree bars form a forest. Orderings that do not traverse call every
/// bar a tree bar; those that do leave as many non-tree bars as there are independent cycles.
TEST_P(OrderLaw, EachSweepVisitsEachBarOnce) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    const std::vector<Vec3> positions = test::shake(example.framework, example.positions, 0.1);
    for (Joint root : roots_of(example.framework)) {
      each_sweep(GetParam(), example.framework, positions, root, [&](auto, const Ordering& now) {
        const auto is_tree = [](const OrderedBar& visit) { return visit.is_tree; };
        const bool traverses = !std::all_of(now.begin(), now.end(), is_tree);
        const OrderingPromise promise{.all_bars = !GetParam().forests_only,
                                      .tree_bars = traverses || GetParam().forests_only};
        EXPECT_EQ(check_ordering(example.framework, now, promise), "");
        if (GetParam().forests_only) {
          EXPECT_EQ(now.size(), example.framework.bar_count() - example.facts.cycles);
        } else if (traverses) {
          EXPECT_EQ(now.size() - std::size_t(std::count_if(now.begin(), now.end(), is_tree)),
                    example.facts.cycles);
        }
      });
    }
  }
}

/// A tree bar is visited from a joint that the root's component already reached.
TEST_P(OrderLaw, TheFirstTraversalGrowsFromTheRoot) {
  for (const Example& example : examples()) {
    if (example.facts.components != 1 || example.facts.cycles == 0) continue;
    SCOPED_TRACE(example.name);
    for (Joint root : roots_of(example.framework)) {
      OrderScratch scratch;
      Ordering now;
      GetParam().order(
          {.framework = example.framework, .root = root, .positions = example.positions}, scratch,
          now);
      const auto non_tree = std::count_if(now.begin(), now.end(),
                                          [](const OrderedBar& visit) { return !visit.is_tree; });
      if (non_tree == 0 && !GetParam().forests_only) continue;  // does not traverse
      std::vector<bool> reached(example.framework.joint_count(), false);
      reached[root] = true;
      for (const OrderedBar& visit : now) {
        const Bar bar = example.framework.bars()[visit.bar];
        const Joint far = visit.near == bar.a ? bar.b : bar.a;
        EXPECT_TRUE(reached[visit.near]);
        EXPECT_EQ(reached[far], !visit.is_tree);
        reached[far] = true;
      }
    }
  }
}

/// The order in which the input names the two ends of a bar means nothing to a traversal.
TEST_P(OrderLaw, SwappingBarEndsChangesOnlyWhatNamesTheFirstJoint) {
  const bool starts_at_first_joint = GetParam().name == "random" || GetParam().name == "input";
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    const Framework swapped = test::with_swapped_ends(example.framework);
    std::vector<Ordering> expected;
    each_sweep(GetParam(), example.framework, example.positions, 0,
               [&](auto, const Ordering& now) { expected.push_back(now); });
    each_sweep(GetParam(), swapped, example.positions, 0, [&](auto sweep, const Ordering& now) {
      ASSERT_EQ(now.size(), expected[std::size_t(sweep)].size());
      for (std::size_t k = 0; k < now.size(); ++k) {
        const OrderedBar was = expected[std::size_t(sweep)][k];
        EXPECT_EQ(now[k].bar, was.bar);
        EXPECT_EQ(now[k].is_tree, was.is_tree);
        EXPECT_EQ(now[k].near == was.near, !starts_at_first_joint);
      }
    });
  }
}

/// Draws depend on seed, walker, step and sweep alone, never on what was asked before.
TEST_P(OrderLaw, SameRequestSameOrdering) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    std::vector<Ordering> first, second;
    for (auto* orderings : {&first, &second})
      each_sweep(GetParam(), example.framework, example.positions, 0,
                 [&](auto, const Ordering& now) { orderings->push_back(now); });
    for (std::size_t sweep = 0; sweep < first.size(); ++sweep)
      EXPECT_TRUE(std::equal(first[sweep].begin(), first[sweep].end(), second[sweep].begin(),
                             second[sweep].end(), [](const OrderedBar& a, const OrderedBar& b) {
                               return a.bar == b.bar && a.near == b.near && a.is_tree == b.is_tree;
                             }));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, OrderLaw, testing::ValuesIn(orderings().begin(), orderings().end()),
                         name_of);

class FileLaw : public testing::TestWithParam<GraphClass> {
 protected:
  struct Pair {
    GeneratedGraph made;
    GraphFile back;
  };

  /// Calls `look(pair)` for graphs of the class and what their files hold.
  template <class Look>
  static void each_graph(std::uint64_t count, Look look) {
    for (std::uint64_t number = 0; number < count; ++number) {
      GeneratedGraph made = generate(GetParam(), {}, {.seed = 11, .walker = number});
      const std::string text = write_graph_xml(made.framework, made.positions, made.cycles);
      GraphFile back = parse_graph_xml({"graph.xml", text});
      EXPECT_EQ(write_graph_xml(back.framework, back.positions, back.cycles), text);
      look(Pair{std::move(made), std::move(back)});
    }
  }
};

TEST_P(FileLaw, GraphsAreReadBackToTheSameBits) {
  each_graph(30, [](const Pair& pair) {
    EXPECT_TRUE(test::same_bits(pair.made.positions, pair.back.positions));
    EXPECT_EQ(pair.made.cycles, pair.back.cycles);
    EXPECT_TRUE(std::ranges::equal(pair.made.framework.bars(), pair.back.framework.bars()));
    EXPECT_TRUE(
        std::ranges::equal(pair.made.framework.rest_lengths(), pair.back.framework.rest_lengths()));
    EXPECT_EQ(class_fault(GetParam(), {}, pair.back.framework), "");
  });
}

TEST_P(FileLaw, OrderingsAreReadBackVisitByVisit) {
  each_graph(5, [](const Pair& pair) {
    const Framework& framework = pair.back.framework;
    for (const OrderingEntry& row : orderings()) {
      if (row.forests_only && GetParam().family != "tree") continue;
      OrderScratch scratch;
      Ordering ordering;
      row.order({.framework = framework, .root = 2, .key = {.seed = 3}}, scratch, ordering);
      const std::string text = write_ordering_file(ordering, pair.made.framework);
      const Ordering back = parse_ordering_file({"ordering.txt", text}, framework);
      EXPECT_TRUE(std::ranges::equal(ordering, back, [](OrderedBar a, OrderedBar b) {
        return a.bar == b.bar && a.near == b.near && a.is_tree == b.is_tree;
      })) << row.name;
    }
  });
}

TEST_P(FileLaw, RunsFromFilesAreRunsFromMemory) {
  each_graph(5, [](const Pair& pair) {
    RunOptions options{.technique = {.name = "random"}, .resolve = {.seed = 8}, .steps = 10};
    State one(pair.made.positions), two(pair.back.positions);
    run(pair.made.framework, one, options, {});
    const ForceFile forces =
        make_force_file(pair.made.framework, options.perturb_options, options.resolve.tolerance,
                        options.resolve.max_sweeps, {.seed = 8}, 10);
    const std::string text = write_force_file(forces, pair.made.framework);
    options.replay = parse_force_file(text, "forces.txt", pair.back.framework).pushes;
    run(pair.back.framework, two, options, {});
    EXPECT_TRUE(test::same_bits(one.positions, two.positions));
    EXPECT_FALSE(test::same_bits(one.positions, pair.made.positions));
  });
}

INSTANTIATE_TEST_SUITE_P(Classes, FileLaw,
                         testing::ValuesIn(graph_classes().begin(), graph_classes().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace pliant::order_law_test
