// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/project_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant {
namespace project_bar_test {

/// No escape is asked for unless the joints coincide.
Vec3 never() {
  ADD_FAILURE() << "asked for an escape";
  return {};
}

TEST(ProjectBar, SharesTheCorrection) {
  Vec3 near{0, 0, 0}, far{3, 4, 0};
  project_bar(near, far, 10.0, 0.25, 0.75, never);
  EXPECT_LT(distance(near, Vec3{-0.75, -1.0, 0.0}), 1e-15);
  EXPECT_LT(distance(far, Vec3{5.25, 7.0, 0.0}), 1e-14);
  EXPECT_NEAR(distance(near, far), 10.0, 1e-14);
}

TEST(ProjectBar, MovesNothingWithoutShares) {
  Vec3 near{0, 0, 0}, far{3, 4, 0};
  project_bar(near, far, 10.0, 0.0, 0.0, never);
  EXPECT_EQ(near, (Vec3{0, 0, 0}));
  EXPECT_EQ(far, (Vec3{3, 4, 0}));
}

TEST(ProjectBar, WholeBarsStayBitForBit) {
  Vec3 near{0.1, 0.2, 0.3}, far{1.1, 0.7, -0.4};
  const Vec3 a = near, b = far;
  project_bar(near, far, distance(a, b), 0.5, 0.5, never);
  EXPECT_EQ(near, a);
  EXPECT_EQ(far, b);
}

/// Joints that coincide, or so nearly that the square of their distance underflows, part along the
/// direction that is asked for.
TEST(ProjectBar, CoincidentJointsPart) {
  for (double apart : {0.0, 1e-160, 9e-151}) {
    Vec3 near{1, 2, 3}, far = near;
    near = {0, 0, 0}, far = {apart, 0, 0};
    int asked = 0;
    project_bar(near, far, 2.0, 0.25, 0.75, [&] {
      ++asked;
      return Vec3{0, 0, 1};
    });
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(near, (Vec3{0, 0, -0.5}));
    EXPECT_EQ(far, (Vec3{apart, 0, 1.5}));
  }
}

TEST(ProjectBar, TinyAndHugeBarsAreExact) {
  for (double scale : {1.1e-150, 1e-75, 1e75, 1e149}) {
    Vec3 near{0, 0, 0}, far{1.5 * scale, 0, 2.0 * scale};
    project_bar(near, far, scale, 0.5, 0.5, never);
    EXPECT_NEAR(distance(near, far) / scale, 1.0, 1e-15);
  }
}

}  // namespace project_bar_test
}  // namespace pliant
