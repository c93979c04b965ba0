// SPDX-License-Identifier: MIT
#include "pliant/measure/convex_hull.hpp"

#include "pliant/base/random.hpp"
#include "support/test.hpp"

namespace pliant::convex_hull_test {

std::vector<Vec3> corners_of_cube() {
  std::vector<Vec3> corners;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) corners.push_back({x, y, z});
  return corners;
}

std::vector<Vec3> points_in_cube(std::size_t count) {
  RandomSequence draws({3, Domain::generate});
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back({draws.uniform() - 0.5, draws.uniform() - 0.5, draws.uniform() - 0.5});
  return points;
}

double highest(const std::vector<Plane>& planes, Vec3 point) {
  double most = -1e9;
  for (const Plane& plane : planes) most = std::max(most, plane.height(point));
  return most;
}

TEST(ConvexHull, OfACubeIsTheCube) {
  std::vector<Vec3> points = corners_of_cube();
  for (const Vec3 inside : points_in_cube(20)) points.push_back(inside);
  const std::vector<Plane> planes = convex_hull(points);
  EXPECT_EQ(planes.size(), 12U);
  EXPECT_NEAR(highest(planes, {0.0, 0.0, 0.0}), -1.0, 1e-12);
  EXPECT_NEAR(highest(planes, {0.2, -3.0, 0.1}), 2.0, 1e-12);
}

TEST(ConvexHull, HasAllPointsInsideAndThreeOnEachFace) {
  const std::vector<Vec3> points = points_in_cube(200);
  const std::vector<Plane> planes = convex_hull(points);
  for (const Vec3 point : points) EXPECT_LE(highest(planes, point), 1e-12);
  for (const Plane& plane : planes) {
    EXPECT_NEAR(norm(plane.normal), 1.0, 1e-12);
    EXPECT_EQ(
        std::ranges::count_if(points, [&](Vec3 p) { return std::abs(plane.height(p)) < 1e-12; }),
        3);
  }
}

TEST(ConvexHull, OfPointsInAPlaneHasNoFaces) {
  std::vector<Vec3> points = points_in_cube(30);
  for (Vec3& point : points) point.z = 0.25;
  EXPECT_TRUE(convex_hull(points).empty());
  EXPECT_TRUE(convex_hull(std::vector<Vec3>(5, Vec3{1.0, 2.0, 3.0})).empty());
  EXPECT_TRUE(convex_hull({}).empty());
}

}  // namespace pliant::convex_hull_test
