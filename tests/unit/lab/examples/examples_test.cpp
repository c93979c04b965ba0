// SPDX-License-Identifier: MIT
#include "pliant/lab/examples/examples.hpp"

#include <gtest/gtest.h>

#include <set>

#include "pliant/base/error.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "support/frameworks.hpp"
#include "support/rigidity.hpp"

namespace pliant {
namespace examples_test {

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

}  // namespace examples_test
}  // namespace pliant
