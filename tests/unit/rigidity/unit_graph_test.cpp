// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/lab/examples/examples.hpp"

namespace pliant {
namespace unit_graph_test {

Framework angles_of(Sketch sketch) { return framework_of(with_angles(std::move(sketch))); }

std::vector<std::size_t> sizes(const UnitSet& set) {
  std::vector<std::size_t> found;
  for (std::size_t unit = 0; unit < set.size(); ++unit) found.push_back(set.at(unit).size());
  std::sort(found.begin(), found.end());
  return found;
}

using Sizes = std::vector<std::size_t>;

/// Each joint that has a neighbour on both sides, with these two.
TEST(FindUnits, OfAChainAreItsAngles) {
  const UnitSet set = find_units(angles_of(chain(8)));
  EXPECT_EQ(sizes(set), Sizes(6, 3));
  EXPECT_EQ(sizes(find_units(framework_of(chain(8)))), Sizes(7, 2)) << "rods";
}

TEST(FindUnits, OfAStarIsOne) { EXPECT_EQ(sizes(find_units(angles_of(star(4)))), Sizes{5}); }

TEST(FindUnits, OfEthaneAreTwoThatShareTheBond) {
  const Framework& ethane = find_example("ethane_with_angles").framework;
  const UnitSet set = find_units(ethane);
  EXPECT_EQ(sizes(set), (Sizes{5, 5}));
  const UnitGraph graph = connect_units(ethane, set);
  ASSERT_EQ(graph.connections.size(), 1u);
  EXPECT_TRUE(graph.connections[0].is_hinge());
  EXPECT_FALSE(graph.has_loops());
}

/// Five joints of a ring all have bars to each other; six make an octahedron.
TEST(FindUnits, OfARingOfFiveIsOne) {
  EXPECT_EQ(sizes(find_units(angles_of(ring(5)))), Sizes{5});
  EXPECT_EQ(sizes(find_units(angles_of(ring(6)))), Sizes(8, 3));
  EXPECT_EQ(sizes(find_units(angles_of(ring(7)))), Sizes(7, 3));
}

/// Where joints have more bars than that, a body would cost more than its bars.
TEST(FindUnits, LeaveHubsOut) {
  Sketch fan = star(300);
  for (Joint k = 1; k < 300; ++k) fan.bars.push_back({k, k + 1});
  EXPECT_EQ(sizes(find_units(framework_of(fan))), Sizes(fan.bars.size(), 2));
}

TEST(MergeRigidLoops, RingsOfUpToSixBodiesAreOne) {
  EXPECT_EQ(merge_rigid_loops(angles_of(ring(6)), find_units(angles_of(ring(6)))).set.size(), 1u);
  for (std::size_t n : {7, 8, 12}) {
    const Framework framework = angles_of(ring(n));
    const UnitSet bodies = find_units(framework);
    EXPECT_EQ(merge_rigid_loops(framework, bodies).set.size(), n) << "n - 6 ways to move";
    EXPECT_EQ(merge_all_loops(framework, bodies).set.size(), 1u);
  }
}

/// Two rings of six that share a bar, as in naphthalene; and three in a row.
TEST(MergeRigidLoops, FusedRingsAreOne) {
  for (std::size_t rings : {2, 3}) {
    Sketch ladder;
    const auto columns = static_cast<Joint>(2 * rings + 1);
    for (Joint k = 0; k < columns; ++k)
      for (double side : {-1.0, 1.0})
        ladder.positions.push_back({0.87 * k, side * (k % 2 == 0 ? 0.5 : 1.0), 0.01 * (k % 3)});
    for (Joint k = 0; k + 1 < columns; ++k)
      for (Joint side : {0u, 1u}) ladder.bars.push_back({2 * k + side, 2 * k + 2 + side});
    for (Joint k = 0; k < columns; k += 2) ladder.bars.push_back({2 * k, 2 * k + 1});
    const Framework framework = angles_of(ladder);
    EXPECT_EQ(merge_rigid_loops(framework, find_units(framework)).set.size(), 1u);
  }
}

/// Two bodies on a hinge have one way to move; a bar across takes it away. Across three hinges it
/// leaves two.
TEST(MergeRigidLoops, ABarAcrossAHingeLocksIt) {
  for (std::size_t joints : {4, 6}) {
    Sketch sketch = with_angles(shaken(chain(joints), 0.2));
    sketch.bars.push_back({0, static_cast<Joint>(joints - 1)});
    const Framework framework = framework_of(sketch);
    const MergedUnits merged = merge_rigid_loops(framework, find_units(framework));
    EXPECT_EQ(merged.set.size(), joints == 4 ? 1u : joints - 1);
  }
}

TEST(ConnectUnits, BarsAloneHangTogetherByJoints) {
  const Framework framework = framework_of(star(5));
  const UnitGraph graph = connect_units(framework, find_units(framework));
  ASSERT_EQ(graph.connections.size(), 1u);
  EXPECT_FALSE(graph.connections[0].is_hinge());
  EXPECT_EQ(graph.links.edge_count(), 5u);
}

}  // namespace unit_graph_test
}  // namespace pliant
