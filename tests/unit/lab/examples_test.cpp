// SPDX-License-Identifier: MIT
#include "pliant/lab/examples/examples.hpp"

#include "pliant/base/choices.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/generate/random_graphs.hpp"
#include "support/frameworks.hpp"
#include "support/rigidity.hpp"
#include "support/test.hpp"

namespace pliant::examples_test {

TEST(Examples, HaveNamesOfTheirOwnAndASource) {
  std::set<std::string_view> names;
  for (const Example& example : examples()) {
    EXPECT_TRUE(names.insert(example.name).second) << example.name;
    EXPECT_FALSE(example.source.empty()) << example.name;
    EXPECT_EQ(&find_example(example.name), &example);
  }
  EXPECT_GE(names.size(), 60u);
}

TEST(Examples, AnUnknownNameIsAnOptionError) { EXPECT_THROW(find_example("none"), OptionError); }

TEST(Examples, GraphFactsAreAsKnown) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    const GraphFacts facts = graph_facts(example.framework);
    EXPECT_EQ(facts.components, example.facts.components);
    EXPECT_EQ(facts.cycles, example.facts.cycles);
    EXPECT_EQ(facts.bridges, example.facts.bridges);
    EXPECT_EQ(facts.blocks, example.facts.blocks);
  }
}

TEST(Examples, PositionsAreWholeWhereTheFactsSaySo) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    ASSERT_EQ(example.positions.size(), example.framework.joint_count());
    EXPECT_TRUE(test::all_finite(example.positions));
    const auto residuals = measure(example.framework, example.positions, {.relative = 1e-12});
    EXPECT_EQ(residuals.within, example.facts.whole);
    EXPECT_TRUE(example.facts.feasible || !example.facts.whole);
  }
}

/// The numbers of the literature against singular values: a slip in a coordinate shows.
TEST(Examples, RankAndRigidMotionsAreAsKnown) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.name);
    const auto& facts = example.facts;
    if (facts.rank) {
      EXPECT_EQ(test::rigidity_rank(example.framework, example.positions), *facts.rank);
    }
    if (facts.rigid_motions) {
      EXPECT_EQ(test::rigid_motions(example.positions), *facts.rigid_motions);
    }
    // Independent bars: the configuration space is smooth there, and counting is exact.
    if (facts.rank == example.framework.bar_count() && facts.flexes && facts.rigid_motions == 6) {
      EXPECT_EQ(*facts.flexes, 3 * example.framework.joint_count() - *facts.rank - 6);
    }
  }
}

TEST(Families, HaveTheCountsOfTheirFormulas) {
  EXPECT_EQ(chain(7).bars.size(), 6u);
  EXPECT_EQ(ring(7).bars.size(), 7u);
  EXPECT_EQ(star(7).positions.size(), 8u);
  EXPECT_EQ(complete(9).bars.size(), 36u);
  EXPECT_EQ(grid(2, 3).bars.size(), 17u);
  EXPECT_EQ(with_angles(ring(9)).bars.size(), 18u);
  EXPECT_EQ(with_angles(star(4)).bars.size(), 4u + 6u);
}

TEST(Families, ChainAndRingHaveUnitBars) {
  for (const Sketch& sketch : {chain(20), straight_chain(20), ring(20), star(20), grid(3, 4)})
    for (double length : drawn_lengths(sketch)) EXPECT_NEAR(length, 1.0, 1e-15);
}

/// R(2,3) = 19 (Bolker, Crapo 1977): the ways to brace cells of a 2 x 3 grid, one diagonal each, so
/// that it is rigid in the plane. The braced grid is pinned to the plane by its rank alone.
TEST(Families, GridBracingsAreCounted) {
  const Sketch plain = grid(2, 3);
  int rigid = 0;
  for (unsigned braced = 0; braced < 64; ++braced) {
    Sketch sketch = plain;
    for (unsigned cell = 0; cell < 6; ++cell)
      if (braced >> cell & 1)
        sketch.bars.push_back({cell / 3 * 4 + cell % 3, cell / 3 * 4 + cell % 3 + 5});
    rigid += test::rigidity_rank(framework_of(sketch), sketch.positions) == 2 * 12 - 3;
  }
  EXPECT_EQ(rigid, 19);
}

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

INSTANTIATE_TEST_SUITE_P(Table, GraphClasses, testing::ValuesIn(names_of(graph_classes())));

TEST(Generate, MakesTreesOfAGivenSizeAndCyclesOfAGivenNumber) {
  GenerateOptions options{.joints = 10000};
  EXPECT_EQ(generate(find_graph_class("tree"), options, graph_number(0)).framework.joint_count(),
            10000u);
  options.joints = 100;
  options.cycles = 50;
  const auto graph = generate(find_graph_class("n-cycle"), options, graph_number(0));
  EXPECT_EQ(graph.framework.bar_count(), 149u);
}

TEST(Generate, NamesABadOption) {
  EXPECT_ERROR(OptionError, "ring = 2: must be from 3",
               generate(find_graph_class("tree"), {.ring = 2}, {}));
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
  const GenerateOptions options{.cycles = 4, .joints = 4};  // a tree of 4 joints leaves 3 pairs
  EXPECT_THROW(generate(find_graph_class("n-cycle"), options, {}), OptionError);
}

}  // namespace pliant::examples_test
