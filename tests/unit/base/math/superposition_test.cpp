// SPDX-License-Identifier: MIT
#include "pliant/base/math/superposition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pliant {
namespace superposition_test {

std::vector<Vec3> tripod() { return {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}, {1, 1, 1}}; }

std::vector<Vec3> moved(std::vector<Vec3> points, double angle, Vec3 shift) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3& p : points) p = Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z} + shift;
  return points;
}

TEST(Superposition, TakesBackARigidMotion) {
  const std::vector<Vec3> goal = tripod(), points = moved(goal, 1.1, {4, -5, 6});
  const RigidMotion motion = superposition(points, goal);
  for (std::size_t k = 0; k < goal.size(); ++k) EXPECT_LT(norm(motion(points[k]) - goal[k]), 1e-12);
}

TEST(Superposition, NeverReflects) {
  std::vector<Vec3> mirrored = tripod();
  for (Vec3& p : mirrored) p.z = -p.z;
  const Rotation r = superposition(mirrored, tripod()).rotation;
  EXPECT_NEAR(dot(r.x, cross(r.y, r.z)), 1.0, 1e-12);
}

TEST(Superposition, TwoPointsAreShiftedOnly) {
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}}, goal{{1, 1, 0}, {1, 3, 0}};
  const RigidMotion motion = superposition(points, goal);
  EXPECT_EQ(motion.rotation.x, (Vec3{1, 0, 0}));
  EXPECT_EQ(motion({0, 0, 0}), (Vec3{0, 2, 0}));
}

TEST(Superposition, OnlyWhatMovesFluctuates) {
  std::vector<std::vector<Vec3>> frames;
  std::vector<Vec3> ring;  // so many points that one of them does not turn the fit
  for (int k = 0; k < 400; ++k) ring.push_back({std::cos(0.1 * k), std::sin(0.1 * k), 0.01 * k});
  for (int k = 0; k < 10; ++k) {
    std::vector<Vec3> frame = ring;
    frame[7] += Vec3{0, 0, k % 2 == 0 ? 0.01 : -0.01};
    frames.push_back(moved(frame, 0.3 * k, {1.0 * k, 2, 3}));
  }
  const std::vector<double> found = superposed_fluctuations(frames);
  EXPECT_NEAR(found[7], 0.01, 2e-4);
  EXPECT_LT(found[8], 3e-4);
  EXPECT_TRUE(superposed_fluctuations({}).empty());
}

}  // namespace superposition_test
}  // namespace pliant
