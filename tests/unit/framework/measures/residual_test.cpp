// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/residual.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/framework/frame.hpp"
#include "pliant/lab/examples/examples.hpp"

namespace pliant {
namespace residual_test {

TEST(Residual, IsPositiveWhenTheBarIsTooLong) {
  EXPECT_EQ(residual({0, 0, 0}, {3, 4, 0}, 4.5), 0.5);
  EXPECT_EQ(residual({3, 4, 0}, {0, 0, 0}, 5.5), -0.5);
}

TEST(Tolerance, IsRelativeUnlessALengthIsGiven) {
  EXPECT_EQ((Tolerance{1e-3, 0.0}.of(2.0)), 2e-3);
  EXPECT_EQ((Tolerance{1e-3, 0.5}.of(2.0)), 0.5);
}

/// Bars of 1 and 2 that are 10 % and 6 % off: the worst is judged relatively.
TEST(Measure, FindsTheWorstBarAndTheMeans) {
  FrameworkParts parts;
  parts.joint_count = 3;
  parts.bars = {{0, 1}, {1, 2}};
  parts.rest_lengths = {2.0, 1.0};
  const Framework framework(std::move(parts));
  const std::vector<Vec3> x{{0, 0, 0}, {2.12, 0, 0}, {2.12, 0.9, 0}};
  const ResidualSummary found = measure(framework, x, {.relative = 0.08});
  EXPECT_NEAR(found.max_relative, 0.1, 1e-15);
  EXPECT_NEAR(found.max_length, 0.12, 1e-15);
  EXPECT_NEAR(found.rms_relative, std::sqrt((0.06 * 0.06 + 0.1 * 0.1) / 2), 1e-15);
  EXPECT_EQ(found.worst_bar, 1u);
  EXPECT_TRUE(found.finite);
  EXPECT_FALSE(found.within);
  EXPECT_TRUE(measure(framework, x, {.relative = 0.11}).within);
  EXPECT_FALSE(measure(framework, x, {.length = 0.11}).within);
  EXPECT_TRUE(measure(framework, x, {.length = 0.13}).within);
}

TEST(Measure, NoBarsAreWhole) {
  const ResidualSummary found = measure(Framework({.joint_count = 2}), std::vector<Vec3>(2));
  EXPECT_TRUE(found.within);
  EXPECT_EQ(found.max_relative, 0.0);
  EXPECT_EQ(found.rms_relative, 0.0);
}

TEST(Measure, NamesTheFirstBarThatIsNoNumber) {
  const Framework framework = framework_of(chain(4));
  for (double bad : {std::nan(""), HUGE_VAL, 1e200}) {
    std::vector<Vec3> x = chain(4).positions;
    x[2].z = bad;
    const ResidualSummary found = measure(framework, x);
    EXPECT_FALSE(found.finite);
    EXPECT_FALSE(found.within);
    EXPECT_EQ(found.worst_bar, 1u);
  }
}

/// A finite length whose square, relative to the bar, overflows.
TEST(Measure, MeansStayFiniteAsLongAsLengthsAre) {
  FrameworkParts parts;
  parts.joint_count = 2;
  parts.bars = {{0, 1}};
  parts.rest_lengths = {1e-10};
  const ResidualSummary found =
      measure(Framework(std::move(parts)), std::vector<Vec3>{{0, 0, 0}, {1e150, 0, 0}});
  EXPECT_TRUE(found.finite);
  EXPECT_EQ(found.max_relative, 1e160);
  EXPECT_EQ(found.rms_relative, 1e160);
}

TEST(Stop, HasNames) {
  EXPECT_EQ(name(Stop::converged), "converged");
  EXPECT_EQ(name(Stop::max_sweeps), "max_sweeps");
  EXPECT_EQ(name(Stop::not_finite), "not_finite");
  EXPECT_EQ(name(Stop::stopped_by_caller), "stopped_by_caller");
}

}  // namespace residual_test
}  // namespace pliant
