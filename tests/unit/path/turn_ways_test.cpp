// SPDX-License-Identifier: MIT
#include "pliant/path/turn_ways.hpp"

#include <gtest/gtest.h>

#include <future>

#include "pliant/path/path_walker.hpp"
#include "unit/path/bent_helix.hpp"

namespace pliant::path_test {
namespace {

/// Two helices, one turned by 150 degrees: no straight line leads from one end to the other.
class TurnedHelix : public testing::Test {
 protected:
  const Structure start = helix(), end = bent_at_c(start, 10, 150.0);
};

TEST_F(TurnedHelix, IsReachedEitherWay) {
  for (const auto& [from, to] : {std::pair{&start, &end}, {&end, &start}}) {
    const MolecularPath path = find_path(*from, *to);
    EXPECT_TRUE(path.has_arrived);
    EXPECT_GT(path.turned, 135.0);
    EXPECT_LT(path.turned, 225.0);
    EXPECT_NEAR(path.frames.front().from_start, 0.0, 1e-9);
    EXPECT_LT(worst_bar(path), 1e-10);
    for (const PathFrame& frame : path.frames) {
      EXPECT_LT(frame.held_off, 0.011) << frame.step;
      EXPECT_LT(frame.overlap, 0.11) << frame.step;
    }
  }
}

TEST_F(TurnedHelix, HasTheSameBitsInEachOfSeveralThreads) {
  const auto walk = [this] { return find_path(end, start).positions; };
  auto one = std::async(std::launch::async, walk), other = std::async(std::launch::async, walk);
  const auto here = walk();
  EXPECT_EQ(one.get(), here);
  EXPECT_EQ(other.get(), here);
}

TEST_F(TurnedHelix, IsGoneToBothWaysRound) {
  const PathEnds ends = match_ends(start, end);
  const std::vector<TurnWay> found = find_turn_ways(ends.start, ends.goal);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].angle + found[1].angle, 360.0, 1e-9);
  EXPECT_NEAR(std::min(found[0].angle, found[1].angle), 150.0, 15.0);
  EXPECT_LE(found[0].clashes, found[1].clashes);
  for (const TurnWay& way : found) {
    EXPECT_EQ(way.goals.back(), ends.goal);
    EXPECT_GT(way.goals.size(), 4U);
    std::vector<Vec3> before = asked_of(ends.start, ends.start.model.positions);
    for (const std::vector<Vec3>& goal : way.goals) {
      EXPECT_LT(rms(ways(before, goal)), 2.0);
      before = goal;
    }
  }
}

TEST(TurnWays, SmallTurnsHaveNone) {
  const PathEnds ends = match_ends(helix(), bent(helix(), 9, 30.0));
  EXPECT_TRUE(find_turn_ways(ends.start, ends.goal).empty());
}

TEST(TurnWays, TheStraightWayComesFirst) {
  const MolecularPath path = find_path(helix(), bent(helix(), 9, 60.0));
  EXPECT_TRUE(path.has_arrived);
  EXPECT_EQ(path.turned, 0.0);
}

}  // namespace
}  // namespace pliant::path_test
