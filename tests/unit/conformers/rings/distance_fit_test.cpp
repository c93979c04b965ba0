// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/distance_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant {
namespace distance_fit_test {

const std::vector<WantedDistance> right_triangle{{0, 1, 9.0}, {1, 2, 16.0}, {0, 2, 25.0}};

TEST(DistanceFit, MeetsATriangle) {
  std::vector<Vec3> x{{0, 0, 0}, {2.5, 0.5, 0}, {3.5, 3, 1}};
  ASSERT_TRUE(meet(right_triangle, x));
  EXPECT_NEAR(distance(x[0], x[1]), 3.0, 1e-12);
  EXPECT_NEAR(distance(x[1], x[2]), 4.0, 1e-12);
  EXPECT_NEAR(distance(x[0], x[2]), 5.0, 1e-12);
}

TEST(DistanceFit, MovesThePointsAlikeAndNotTheirMiddle) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}};
  ASSERT_TRUE(meet({{0, 1, 4.0}}, x));
  EXPECT_NEAR(distance(x[0], {-0.5, 0, 0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(x[1], {1.5, 0, 0}), 0.0, 1e-12);
}

TEST(DistanceFit, GivesUpWhereNoPlaceMeetsAll) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}};
  EXPECT_FALSE(meet({{0, 1, 1.0}, {1, 2, 1.0}, {0, 2, 9.0}}, x));
}

TEST(DistanceFit, AStepSaysHowFarOffItWasAndGoesLessFarIfDamped) {
  std::vector<Vec3> free{{0, 0, 0}, {1, 0, 0}}, damped = free;
  EXPECT_DOUBLE_EQ(approach({{0, 1, 4.0}}, 0.0, free), 0.75);
  EXPECT_DOUBLE_EQ(approach({{0, 1, 4.0}}, 1.0, damped), 0.75);
  // One step of Newton: the length grows by (4 - 1) / (2 * 1), half of that where damped by 1.
  EXPECT_NEAR(distance(free[0], free[1]), 2.5, 1e-12);
  EXPECT_NEAR(distance(damped[0], damped[1]), 1.75, 1e-12);
}

}  // namespace distance_fit_test
}  // namespace pliant
