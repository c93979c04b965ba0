// SPDX-License-Identifier: MIT
#include "pliant/lab/generate/random_graphs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {
namespace random_graphs_test {

RandomKey graph_number(std::uint64_t number) { return {5, Domain::generate, number, 0, 0}; }

bool has_bar(const Framework& framework, Joint a, Joint b) {
  const auto around = framework.neighbours(a);
  return std::any_of(around.begin(), around.end(),
                     [b](const Incidence& at) { return at.joint == b; });
}

class GraphClasses : public testing::TestWithParam<std::string_view> {};

TEST_P(GraphClasses, MakeConnectedGraphsOfTheirClassWithWholeBars) {
  const GraphClass& kind = find_graph_class(GetParam());
  for (std::uint64_t number = 0; number < 100; ++number) {
    const GeneratedGraph graph = generate(kind, {}, graph_number(number));
    const GraphFacts facts = graph_facts(graph.framework);
    EXPECT_EQ(facts.components, 1u);
    EXPECT_EQ(facts.cycles, graph.cycles.size());
    EXPECT_TRUE(measure(graph.framework, graph.positions, {1e-15}).within);
    for (Vec3 x : graph.positions) EXPECT_TRUE(x.x >= 0 && x.x < 10 && x.y >= 0 && x.z < 10);
  }
}

TEST_P(GraphClasses, ListCyclesThatAreCycles) {
  const GraphClass& kind = find_graph_class(GetParam());
  for (std::uint64_t number = 0; number < 20; ++number) {
    const GeneratedGraph graph = generate(kind, {}, graph_number(number));
    for (const auto& cycle : graph.cycles) {
      ASSERT_GE(cycle.size(), 3u);
      for (std::size_t k = 0; k < cycle.size(); ++k)
        EXPECT_TRUE(has_bar(graph.framework, cycle[k], cycle[(k + 1) % cycle.size()]));
    }
  }
}

TEST_P(GraphClasses, DependOnTheSeedAndTheNumberAlone) {
  const GraphClass& kind = find_graph_class(GetParam());
  const auto once = generate(kind, {}, graph_number(3)).positions;
  EXPECT_EQ(once, generate(kind, {}, graph_number(3)).positions);
  EXPECT_NE(once, generate(kind, {}, graph_number(4)).positions);
}

std::vector<std::string_view> class_names() {
  std::vector<std::string_view> names;
  for (const GraphClass& row : graph_classes()) names.push_back(row.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Table, GraphClasses, testing::ValuesIn(class_names()));

TEST(Generate, MakesTreesOfAGivenSizeAndCyclesOfAGivenNumber) {
  GenerateOptions options;
  options.joints = 10000;
  EXPECT_EQ(generate(find_graph_class("tree"), options, graph_number(0)).framework.joint_count(),
            10000u);
  options.joints = 100;
  options.cycles = 50;
  const auto graph = generate(find_graph_class("n-cycle"), options, graph_number(0));
  EXPECT_EQ(graph.framework.bar_count(), 149u);
}

TEST(Generate, NamesABadOption) {
  GenerateOptions options;
  options.ring = 2;
  try {
    generate(find_graph_class("tree"), options, {});
    FAIL();
  } catch (const OptionError& error) {
    EXPECT_STREQ(error.what(), "ring = 2: must be from 3");
  }
}

/// At once, whatever a tree of 2^63 joints would take.
TEST(Generate, RefusesSizesThatNoMemoryHolds) {
  for (const GenerateOptions options : {GenerateOptions{.depth = 63},
                                        {.depth = std::int64_t{1} << 62, .children = 1},
                                        {.children = std::int64_t{1} << 62},
                                        {.ring = std::int64_t{1} << 62},
                                        {.joints = std::int64_t{1} << 62}})
    EXPECT_THROW(check(options), OptionError);
  check(GenerateOptions{.depth = 1'000'000, .children = 1});
  check(GenerateOptions{.depth = 20});
}

TEST(Generate, SaysWhenNoPairIsLeft) {
  GenerateOptions options;
  options.joints = 4;
  options.cycles = 4;  // a tree of 4 joints leaves 3 pairs
  EXPECT_THROW(generate(find_graph_class("n-cycle"), options, {}), OptionError);
}

}  // namespace random_graphs_test
}  // namespace pliant
