// SPDX-License-Identifier: MIT
#include "pliant/rigidity/pebble_game.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace pebble_game_test {

TEST(PebbleGame, TwoBodiesTakeSixBars) {
  PebbleGame game(2);
  EXPECT_EQ(game.add(0, 1, 5), 5u);
  EXPECT_FALSE(game.are_locked(0, 1));
  EXPECT_EQ(game.add(1, 0, 3), 1u);
  EXPECT_TRUE(game.are_locked(0, 1));
  EXPECT_EQ(game.add(0, 1, 2), 0u);
  EXPECT_EQ(game.rank(), 6u);
}

TEST(PebbleGame, SixOrMoreBarsAtOnceMakeOneBody) {
  PebbleGame game(3);
  EXPECT_EQ(game.add(2, 1, 200), 6u);
  EXPECT_EQ(game.cluster_of(2), 1u);
  EXPECT_EQ(game.cluster_of(0), 0u);
  EXPECT_EQ(game.add(0, 2, 0), 0u) << "no bars";
}

/// A body on three bars to each of two others is locked when these two are.
TEST(PebbleGame, LocksABodyBetweenTwoThatAreLockedLater) {
  PebbleGame game(3);
  EXPECT_EQ(game.add(2, 0, 3), 3u);
  EXPECT_EQ(game.add(2, 1, 3), 3u);
  EXPECT_FALSE(game.are_locked(0, 2));
  EXPECT_EQ(game.add(0, 1, 6), 6u);
  EXPECT_TRUE(game.are_locked(0, 2));
  EXPECT_TRUE(game.are_locked(1, 2));
  EXPECT_EQ(game.cluster_of(2), 0u);
}

/// No recursion, and no search that grows with what is locked: seconds would be minutes.
TEST(PebbleGame, CountsAHundredThousandBodiesInARowAndTheirClosing) {
  constexpr std::uint32_t bodies = 100'000;
  PebbleGame game(bodies);
  for (std::uint32_t k = 0; k + 1 < bodies; ++k) ASSERT_EQ(game.add(k, k + 1, 5), 5u);
  EXPECT_EQ(game.add(bodies - 1, 0, 5), 5u);
  for (std::uint32_t k = 0; k + 6 < bodies; ++k) game.add(k, k + 6, 5);
  EXPECT_EQ(game.rank(), 6u * (bodies - 1));
  EXPECT_EQ(game.cluster_of(bodies - 1), 0u);
}

}  // namespace pebble_game_test
}  // namespace pliant
