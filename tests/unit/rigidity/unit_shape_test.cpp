// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_shape.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"

namespace pliant {
namespace unit_shape_test {

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

}  // namespace unit_shape_test
}  // namespace pliant
