// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/residual.hpp"

#include "pliant/framework/frame.hpp"
#include "pliant/framework/measures/check_positions.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/framework/measures/loads.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::residual_test {

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
  const Framework framework(
      {.joint_count = 3, .bars = {{0, 1}, {1, 2}}, .rest_lengths = {2.0, 1.0}});
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
  const ResidualSummary found =
      measure(Framework({.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1e-10}}),
              std::vector<Vec3>{{0, 0, 0}, {1e150, 0, 0}});
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

/// What is said of unit bars with all coordinates shifted by `offset`: an error, or warnings.
std::string verdict_at(double offset, const Tolerance& tolerance = {}) {
  const Sketch sketch = chain(3);
  std::vector<Vec3> x = sketch.positions;
  for (Vec3& p : x) p += Vec3{offset, offset, offset};
  std::string said;
  const Log log{[&](Severity severity, std::string_view text) {
    EXPECT_EQ(severity, Severity::warning);
    said += text;
  }};
  const std::string thrown = test::error_text<InputError>(
      [&] { check_positions(framework_of(sketch), x, tolerance, log); });
  return thrown.empty() ? said : "error: " + thrown;
}

/// At 1e8 Angstrom doubles are 1.5e-8 apart: the default tolerance can be met, 1e-10 cannot. At
/// 1e16 they are 2 apart: unit bars collapse.
TEST(CheckPositions, SaysWhereDoublesAreTooCoarse) {
  const char* far =
      "coordinates reach 1e+08 Angstrom, where doubles are 2.2e-08 apart: the tolerance of bar 0 - "
      "1 "
      "cannot be met";
  EXPECT_EQ(verdict_at(0.0), "");
  EXPECT_EQ(verdict_at(1e8), "");
  EXPECT_EQ(verdict_at(1e8, {.relative = 1e-10}), far);
  EXPECT_EQ(verdict_at(-1e8, {.relative = 1e-6, .length = 1e-9}), far);
  EXPECT_EQ(verdict_at(1e16),
            "error: coordinates reach 1e+16 Angstrom, where doubles are 2.2 apart: too coarse for "
            "bar 0 - 1; move the molecule to the origin");
  EXPECT_EQ(verdict_at(1e160),
            "error: coordinates reach 1e+160 Angstrom: must be within 1e150 of the origin");
  EXPECT_EQ(verdict_at(std::nan("")), "error: position of joint 0 is not finite");
  EXPECT_EQ(verdict_at(HUGE_VAL), "error: position of joint 0 is not finite");
}

TEST(CheckPositions, RefusesAnotherNumberOfPositions) {
  EXPECT_ERROR(InputError, "framework: 3 joints but 2 positions",
               check_positions(framework_of(chain(3)), std::vector<Vec3>(2), {}, {}));
}

TEST(CheckPositions, TakesJointsWithoutBars) {
  EXPECT_NO_THROW(check_positions(Framework({.joint_count = 2}),
                                  std::vector<Vec3>(2, Vec3{1e16, 0, 0}), {}, {}));
}

/// A hydrogen bond of three limits, a tether of one in a group, and one of no group.
const std::vector<Limit> limits{{.a = 0, .b = 1, .most = 2.0, .group = 7},
                                {.a = 0, .b = 2, .most = 3.0, .group = 7},
                                {.a = 1, .b = 2, .least = 1.0, .group = 7},
                                {.a = 2, .b = 3, .most = 4.0, .group = 9},
                                {.a = 0, .b = 3, .least = 5.0, .most = 6.0}};
const std::vector<Vec3> held{{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {6, 0, 0}};

LimitCounts count(std::span<const Vec3> places, double tolerance,
                  std::span<const std::uint8_t> off = {}) {
  return LimitCounter(limits).count(places, off, tolerance);
}

std::vector<Vec3> held_but(Joint joint, Vec3 place) {
  std::vector<Vec3> moved = held;
  moved[joint] = place;
  return moved;
}

TEST(LimitCounts, AGroupIsOneThingThatOneLimitBreaks) {
  EXPECT_EQ(LimitCounter(limits).size(), 3U);
  EXPECT_EQ(count(held, 0.1), (LimitCounts{3, 0, 0}));
  const std::vector<Vec3> one = held_but(1, {2.05, 0, 0});
  EXPECT_EQ(count(one, 0.1), (LimitCounts{3, 0, 0}));
  EXPECT_EQ(count(one, 0.01), (LimitCounts{2, 1, 0}));
  const std::vector<Vec3> alone = held_but(3, {6.2, 0, 0});  // only the limit of no group
  EXPECT_EQ(count(alone, 0.1), (LimitCounts{2, 1, 0}));
  EXPECT_EQ(count(held_but(3, {1e300, 1e300, 0}), 0.1), (LimitCounts{1, 2, 0})) << "no length";
  EXPECT_EQ(LimitCounter({}).count(held, {}, 0.1), LimitCounts{});
}

TEST(LimitCounts, WhatIsOffIsNeitherHeldNorBroken) {
  LimitCounter counter(limits);
  EXPECT_EQ(counter.count(held_but(3, {20, 0, 0}), std::vector<std::uint8_t>{0, 1, 0, 1, 0}, 0.1),
            (LimitCounts{0, 1, 2}));
  constexpr ContactState off_now = ContactState::off;
  EXPECT_THAT(counter.states(), testing::ElementsAre(off_now, off_now, ContactState::broken));
}

constexpr double accuracy = 1e-2;

Loads loads_of(const Framework& framework, std::span<const Vec3> x, Joint joint, Vec3 force) {
  const Load pull{joint, force};
  return find_loads(framework, x, {&pull, 1});
}

/// A rod of n joints drawn along itself: each gives way by 1/n, and tension falls off evenly.
TEST(Loads, OfAStraightChain) {
  const Sketch sketch = straight_chain(5);
  const Loads found = loads_of(framework_of(sketch), sketch.positions, 4, {1.0, 0.0, 0.0});
  EXPECT_NEAR(found.yields(4, {1.0, 0.0, 0.0}), 0.2, accuracy);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(found.bars[k], 0.2 * (k + 1), accuracy) << k;
  const Loads pressed = loads_of(framework_of(sketch), sketch.positions, 4, {-1.0, 0.0, 0.0});
  EXPECT_NEAR(pressed.bars[3], -0.8, accuracy);
  const Loads across = loads_of(framework_of(sketch), sketch.positions, 4, {0.0, 1.0, 0.0});
  EXPECT_NEAR(across.yields(4, {0.0, 1.0, 0.0}), 1.0, accuracy) << "no bar holds it";
}

TEST(Loads, OfAPin) {
  const Sketch sketch = straight_chain(3);
  const Framework framework = test::with_pinned(framework_of(sketch), {0});
  const Loads found = loads_of(framework, sketch.positions, 2, {5.0, 0.0, 0.0});
  EXPECT_NEAR(found.pins[0], 5.0, 5 * accuracy);
  EXPECT_NEAR(found.yields(2, {5.0, 0.0, 0.0}), 0.0, accuracy);
  EXPECT_NEAR(found.bars[0], 5.0, 5 * accuracy);
  EXPECT_EQ(found.motion[0], Vec3());
}

/// Two joints and a pinned one: a limit holds one way, and only where it is reached.
TEST(Loads, OfLimitsAreOneSided) {
  const FrameworkParts parts{.joint_count = 2, .pinned = {0}, .limits = {{0, 1, 0.0, 3.0}}};
  const std::vector<Vec3> taut{{}, {2.98, 0.0, 0.0}}, slack{{}, {2.5, 0.0, 0.0}};
  const Framework framework(parts);
  EXPECT_NEAR(loads_of(framework, taut, 1, {1.0, 0.0, 0.0}).limits[0], 1.0, accuracy);
  EXPECT_EQ(loads_of(framework, taut, 1, {-1.0, 0.0, 0.0}).limits[0], 0.0);
  EXPECT_EQ(loads_of(framework, slack, 1, {1.0, 0.0, 0.0}).limits[0], 0.0);
}

/// Of two limits side by side each carries half: neither is named alone.
TEST(Loads, AreSharedByWhatHoldsTogether) {
  const FrameworkParts parts{
      .joint_count = 3, .pinned = {0, 1}, .limits = {{0, 2, 0.0, 3.0}, {1, 2, 0.0, 3.0}}};
  const std::vector<Vec3> x{{0.0, 0.1, 0.0}, {0.0, -0.1, 0.0}, {3.0, 0.0, 0.0}};
  const Loads found = loads_of(Framework(parts), x, 2, {1.0, 0.0, 0.0});
  EXPECT_NEAR(found.limits[0], found.limits[1], accuracy);
  EXPECT_NEAR(found.limits[0] + found.limits[1], 1.0, accuracy);
}

TEST(Loads, OfJointsThatTouch) {
  const FrameworkParts parts{.joint_count = 2, .pinned = {0}, .sterics = test::spheres(2, 2.0)};
  const std::vector<Vec3> x{{}, {2.02, 0.0, 0.0}};
  const Loads found = loads_of(Framework(parts), x, 1, {-1.0, 0.0, 0.0});
  ASSERT_EQ(found.pressed.size(), 1u);
  EXPECT_NEAR(found.pressed[0].load, 1.0, accuracy);
  EXPECT_TRUE(loads_of(Framework(parts), x, 1, {1.0, 0.0, 0.0}).pressed.empty());
}

}  // namespace pliant::residual_test
