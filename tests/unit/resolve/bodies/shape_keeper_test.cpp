// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/shape_keeper.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/equations/kept_shapes.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace shape_keeper_test {

/// A centre a little above the plane of its three neighbours, all held to each other: its mirror
/// image has the same lengths.
Framework flat_group(std::vector<Joint> pinned = {}) {
  FrameworkParts parts;
  parts.joint_count = 4;
  parts.pinned = std::move(pinned);
  parts.drawn = {{0, 0, 0.05}, {1.4, 0, 0}, {-0.7, 1.2, 0}, {-0.7, -1.2, 0}};
  parts.bars = complete(4).bars;
  for (Bar bar : parts.bars)
    parts.rest_lengths.push_back(distance(parts.drawn[bar.a], parts.drawn[bar.b]));
  return Framework(std::move(parts));
}

/// Of joint 0 above the plane of the others, when those are passed against the clock (Angstrom^3).
double volume(std::span<const Vec3> x) { return dot(x[0] - x[1], cross(x[2] - x[1], x[3] - x[1])); }

std::vector<Vec3> mirrored(std::span<const Vec3> x) {
  std::vector<Vec3> y(x.begin(), x.end());
  for (Vec3& p : y) p.z = -p.z;
  return y;
}

class ShapeKeeper : public testing::TestWithParam<const char*> {};

TEST_P(ShapeKeeper, PutsAnAtomBackOnItsSideOfThePlane) {
  const Framework framework = flat_group();
  const double drawn = volume(framework.drawn());
  for (double height : {-0.3, -0.1, -0.05, 0.02, 0.3}) {
    std::vector<Vec3> x(framework.drawn().begin(), framework.drawn().end());
    x[0].z = height;
    const ResolveSummary summary =
        Resolver(framework, {GetParam()}).resolve(x, 0, 0, framework.drawn());
    EXPECT_TRUE(summary.converged()) << height;
    EXPECT_NEAR(volume(x), drawn, 1e-2 * drawn) << height;
  }
}

TEST_P(ShapeKeeper, LeavesWhatWasMirroredBeforeThePush) {
  const Framework framework = flat_group();
  const std::vector<Vec3> before = mirrored(framework.drawn());
  std::vector<Vec3> x = before;
  x[1].x += 0.05;
  EXPECT_TRUE(Resolver(framework, {GetParam()}).resolve(x, 1, 0, before).converged());
  EXPECT_NEAR(volume(x), volume(before), -1e-2 * volume(before));
}

TEST_P(ShapeKeeper, LeavesPinnedJoints) {
  const Framework framework = flat_group({1, 2, 3});
  std::vector<Vec3> x(framework.drawn().begin(), framework.drawn().end());
  x[0].z = -0.1;
  Resolver(framework, {GetParam()}).resolve(x, 0, 0, framework.drawn());
  for (Joint joint : {1, 2, 3}) EXPECT_TRUE(x[joint] == framework.drawn()[joint]) << joint;
}

INSTANTIATE_TEST_SUITE_P(Direct, ShapeKeeper, testing::Values("newton", "shake"),
                         [](const auto& row) { return std::string(row.param); });

TEST(KeptShapes, AreThoseOfDrawnUnitsOfFourJoints) {
  EXPECT_FALSE(KeptShapes(flat_group(), {}).empty());
  EXPECT_TRUE(KeptShapes(framework_of(chain(9)), {}).empty()) << "no units";
  FrameworkParts lengths_alone = test::parts_of(flat_group());
  lengths_alone.drawn = {};
  EXPECT_TRUE(KeptShapes(Framework(std::move(lengths_alone)), {}).empty());
  FrameworkParts of_the_plane = test::parts_of(framework_of(grid(2, 2)));
  of_the_plane.planar = true;
  EXPECT_TRUE(KeptShapes(Framework(std::move(of_the_plane)), {}).empty());
}

}  // namespace shape_keeper_test
}  // namespace pliant
