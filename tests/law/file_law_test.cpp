// SPDX-License-Identifier: MIT
// What is generated, written and read again is the same, for every class of graphs: the graph,
// every ordering of it, and its forces; and a run from the files is the run from memory.
#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/lab/generate/random_graphs.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"

namespace pliant {

void PrintTo(const GraphClass& row, std::ostream* out) { *out << row.name; }

namespace file_law_test {

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
    RunOptions options;
    options.steps = 10;
    options.resolve.seed = 8;
    options.technique.name = "random";
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

}  // namespace file_law_test
}  // namespace pliant
