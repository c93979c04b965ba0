// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/sweep_groups.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace sweep_groups_test {

/// A triangle 0 1 2, a bridge 2 3, a triangle 3 4 5 that shares joint 5 with a triangle 5 6 7, and
/// a bar 8 9 apart.
Framework two_ring_systems(std::vector<Joint> pinned = {}) {
  FrameworkParts parts;
  parts.joint_count = 10;
  parts.bars = {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5},
                {5, 3}, {5, 6}, {6, 7}, {7, 5}, {8, 9}};
  parts.rest_lengths.assign(parts.bars.size(), 1.0);
  parts.pinned = std::move(pinned);
  return Framework(std::move(parts));
}

BarGroups groups_of(const Framework& framework) {
  return group_ring_systems(framework, OutwardPlanner(framework));
}

using Joints = std::vector<Joint>;

TEST(SweepGroups, AreTheBlocks) {
  const BarGroups groups = groups_of(two_ring_systems());
  EXPECT_EQ(groups.joints, (std::vector<Joints>{{0, 1, 2}, {3, 4, 5}, {5, 6, 7}}));
  EXPECT_EQ(groups.of_bar,
            (std::vector<std::uint32_t>{0, 0, 0, no_group, 1, 1, 1, 2, 2, 2, no_group}));
  EXPECT_EQ(groups.of_block, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(groups.is_carried, (std::vector<bool>{true, true, true}));
}

TEST(SweepGroups, OnePinnedJointLeavesEverythingElseFreeToBeCarried) {
  EXPECT_EQ(groups_of(two_ring_systems({3})).of_bar, groups_of(two_ring_systems()).of_bar);
}

TEST(SweepGroups, BetweenPinnedJointsNothingIsCarried) {
  const BarGroups groups = groups_of(two_ring_systems({0, 4}));
  EXPECT_EQ(groups.joints, (std::vector<Joints>{{0, 1, 2, 3, 4, 5, 6, 7}}));
  EXPECT_EQ(groups.is_carried, (std::vector<bool>{false}));
  EXPECT_EQ(groups.of_bar.back(), no_group) << "the other component has no pinned joint";
  EXPECT_EQ(groups.of_bar.front(), 0u);
  EXPECT_EQ(groups.of_block, (std::vector<std::uint32_t>{no_group, no_group, no_group}));
}

TEST(SweepGroups, CanBeEverything) {
  const BarGroups groups = group_all_bars(two_ring_systems());
  EXPECT_EQ(groups.joints, (std::vector<Joints>{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  EXPECT_EQ(groups.of_bar, std::vector<std::uint32_t>(11, 0));
}

}  // namespace sweep_groups_test
}  // namespace pliant
