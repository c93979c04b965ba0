// SPDX-License-Identifier: MIT
#include "pliant/path/march.hpp"

#include <gtest/gtest.h>

namespace pliant::march_test {

TEST(Patience, IsOverWhereEightStepsGainTooLittle) {
  Patience patience(0.2, 1.0);
  for (int step = 0; step < 7; ++step) EXPECT_FALSE(patience.is_over(0.999)) << step;
  EXPECT_TRUE(patience.is_over(0.999));
}

TEST(Patience, IsNotOverWhileStepsGain) {
  Patience patience(0.2, 1.0);
  for (int step = 1; step < 40; ++step) EXPECT_FALSE(patience.is_over(1.0 - 0.0026 * step)) << step;
}

TEST(Patience, IsOverAtTheGoal) { EXPECT_TRUE(Patience(0.2, 1.0).is_over(1e-7)); }

TEST(Patience, AsksForLessOfSmallSteps) {
  Patience patience(0.01, 1.0);
  for (int step = 1; step < 40; ++step) EXPECT_FALSE(patience.is_over(1.0 - 0.0006 * step)) << step;
}

TEST(Way, FirstPlacesAreWithoutNotes) {
  Way way;
  for (int k = 0; k < 3; ++k) way.add(std::make_shared<const PathPlace>(), double(k));
  way.notes.emplace_back("ended");
  const Way first = way.first(2);
  EXPECT_EQ(first.places.size(), 2U);
  EXPECT_EQ(first.left, (std::vector<double>{0.0, 1.0}));
  EXPECT_TRUE(first.notes.empty());
}

TEST(Ways, LeadToTheGoalWhereverItLies) {
  const std::vector<Vec3> here{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  std::vector<Vec3> goal;
  for (Vec3 x : here) goal.push_back(Vec3{-x.y, x.x, x.z} + Vec3{7, 8, 9});  // turned and shifted
  EXPECT_LT(rms(ways(here, goal)), 1e-14);
  EXPECT_EQ(rms({}), 0.0);
}

}  // namespace pliant::march_test
