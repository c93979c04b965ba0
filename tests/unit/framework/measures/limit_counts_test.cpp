// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/limit_counts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace limit_counts_test {

/// A hydrogen bond of three limits, a tether of one in a group, and one of no group.
const std::vector<Limit> limits{{.a = 0, .b = 1, .most = 2.0, .group = 7},
                                {.a = 0, .b = 2, .most = 3.0, .group = 7},
                                {.a = 1, .b = 2, .least = 1.0, .group = 7},
                                {.a = 2, .b = 3, .most = 4.0, .group = 9},
                                {.a = 0, .b = 3, .least = 5.0, .most = 6.0}};
const std::vector<Vec3> held{{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {6, 0, 0}};

TEST(LimitCounts, AGroupIsOneThing) {
  LimitCounter counter(limits);
  EXPECT_EQ(counter.size(), 3U);
  EXPECT_EQ(counter.count(held, {}, 0.1), (LimitCounts{3, 0, 0}));
}

TEST(LimitCounts, OneLimitBreaksItsGroup) {
  LimitCounter counter(limits);
  std::vector<Vec3> moved = held;
  moved[1].x = 2.05;
  EXPECT_EQ(counter.count(moved, {}, 0.1), (LimitCounts{3, 0, 0}));
  EXPECT_EQ(counter.count(moved, {}, 0.01), (LimitCounts{2, 1, 0}));
  moved[3].x = 6.2;  // only the limit of no group
  EXPECT_EQ(counter.count(moved, {}, 0.1), (LimitCounts{2, 1, 0}));
  EXPECT_EQ(counter.count(moved, {}, 0.01), (LimitCounts{1, 2, 0}));
}

TEST(LimitCounts, WhatIsOffIsNeitherHeldNorBroken) {
  LimitCounter counter(limits);
  std::vector<Vec3> moved = held;
  moved[3].x = 20.0;
  const std::vector<std::uint8_t> off{0, 1, 0, 1, 0};
  EXPECT_EQ(counter.count(moved, off, 0.1), (LimitCounts{0, 1, 2}));
  constexpr ContactState off_now = ContactState::off;
  EXPECT_THAT(counter.states(), testing::ElementsAre(off_now, off_now, ContactState::broken));
}

TEST(LimitCounts, ALengthThatIsNotFiniteIsBroken) {
  LimitCounter counter(limits);
  std::vector<Vec3> moved = held;
  moved[3].x = 1e300;
  moved[3].y = 1e300;
  EXPECT_EQ(counter.count(moved, {}, 0.1), (LimitCounts{1, 2, 0}));
}

TEST(LimitCounts, NoLimitsAreNothing) {
  LimitCounter counter({});
  EXPECT_EQ(counter.size(), 0U);
  EXPECT_EQ(counter.count(held, {}, 0.1), LimitCounts{});
}

}  // namespace limit_counts_test
}  // namespace pliant
