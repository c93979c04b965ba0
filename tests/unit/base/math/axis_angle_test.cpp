// SPDX-License-Identifier: MIT
#include "pliant/base/math/axis_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant::axis_angle_test {

TEST(AxisAngle, IsThatOfTheRotation) {
  const Vec3 axis{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0};
  for (const double angle : {0.01, 1.0, 2.0, 3.1}) {
    const AxisAngle found = axis_angle(rotation_by(axis, angle));
    EXPECT_NEAR(found.angle, angle, 1e-12);
    EXPECT_LT(distance(found.axis, axis), 1e-11);
  }
}

TEST(AxisAngle, OfHalfATurnIsPi) {
  const Vec3 axis{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0};
  const Rotation half{2.0 * axis.x * axis - Vec3{1, 0, 0}, 2.0 * axis.y * axis - Vec3{0, 1, 0},
                      2.0 * axis.z * axis - Vec3{0, 0, 1}};
  const AxisAngle found = axis_angle(half);
  EXPECT_NEAR(found.angle, 3.14159265358979, 1e-7);
  EXPECT_NEAR(std::abs(dot(found.axis, axis)), 1.0, 1e-12);
}

TEST(AxisAngle, OfNoRotationIsZero) { EXPECT_EQ(axis_angle(Rotation{}).angle, 0.0); }

TEST(RotationBy, TurnsByTheAngle) {
  for (const double angle : {0.5, 3.0, 4.0, 6.0}) {
    const Vec3 x = rotation_by({0, 0, 1}, angle)({1, 0, 5});
    EXPECT_LT(distance(x, {std::cos(angle), std::sin(angle), 5}), 1e-12) << angle;
    EXPECT_LT(distance(inverse(rotation_by({0, 0, 1}, angle))(x), {1, 0, 5}), 1e-12) << angle;
  }
}

}  // namespace pliant::axis_angle_test
