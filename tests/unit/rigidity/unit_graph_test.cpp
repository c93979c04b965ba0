// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_graph.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/rigidity/unit_shape.hpp"
#include "support/test.hpp"

namespace pliant::unit_graph_test {

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

double worst_error(const Framework& framework, const UnitSet& set, const UnitShapes& shapes) {
  std::vector<Vec3> x(framework.joint_count());
  std::vector<Vec3> room;
  for (std::size_t unit = 0; unit < set.size(); ++unit) {
    const auto points = points_of(framework, set, shapes, unit, room);
    for (std::size_t k = 0; k < points.size(); ++k) x[set.at(unit)[k]] = points[k];
  }
  return measure(framework, x).max_relative;
}

/// Random clouds, flat ones and ones on a line: distances give the shape back to rounding.
TEST(FindUnitShapes, LengthsGiveTheShapeBack) {
  for (std::size_t joints = 3; joints <= 12; ++joints)
    for (double height : {1.0, 1e-6, 0.0}) {
      Sketch sketch = complete(joints);
      for (Vec3& p : sketch.positions) p.z *= height;
      const Framework framework = framework_of(sketch);
      const UnitSet set = find_units(framework);
      const UnitShapes shapes = find_unit_shapes(framework, set, {1e-12});
      ASSERT_EQ(shapes.kinds, std::vector<ShapeKind>{ShapeKind::lengths});
      EXPECT_LT(worst_error(framework, set, shapes), 1e-13);
    }
}

TEST(FindUnitShapes, LengthsThatFitNoShapeAreUnknown) {
  for (const char* name : {"K4_five_unit_bars_one_1.8", "K5_all_unit", "triangle_1_1_3"}) {
    const Framework& framework = find_example(name).framework;
    const UnitSet set = find_units(framework);
    EXPECT_EQ(find_unit_shapes(framework, set, {}).kinds,
              std::vector<ShapeKind>{ShapeKind::unknown})
        << name;
  }
}

TEST(FindUnitShapes, DrawnPositionsAreTaken) {
  const Sketch sketch = with_angles(ring(6));
  FrameworkParts parts{
      .joint_count = 6, .bars = sketch.bars, .rest_lengths = drawn_lengths(sketch)};
  parts.drawn = sketch.positions;
  const Framework framework(std::move(parts));
  UnitSet set;
  const std::vector<Joint> all{0, 1, 2, 3, 4, 5};
  set.add(all);
  const UnitShapes shapes = find_unit_shapes(framework, set, {});
  EXPECT_EQ(shapes.kinds, std::vector<ShapeKind>{ShapeKind::drawn});
  EXPECT_LT(worst_error(framework, set, shapes), 1e-15);
}

}  // namespace pliant::unit_graph_test
