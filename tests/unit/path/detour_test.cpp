// SPDX-License-Identifier: MIT
#include "pliant/path/detour.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pliant::detour_test {

/// By NumPy: numbers of np.random.Philox(key=[9, 2]), smoothed by np.exp.
TEST(SmoothField, IsNumpysNoiseSmoothedAlongTheResidues) {
  const std::vector<Vec3> expected{{0.435407317830388, -0.544916922898782, -0.150685811439069},
                                   {0.597467749312418, -0.507064239336695, -0.160334902789632},
                                   {0.751039964457104, -0.441641205247073, -0.16282945032068},
                                   {0.87370789230756, -0.363110124701447, -0.157947383844347},
                                   {0.9467750813822, -0.286682564406719, -0.146390069809795},
                                   {0.959895403478058, -0.223636646676238, -0.129628732192128},
                                   {0.913387206529687, -0.178627107115408, -0.109624053720895}};
  const std::vector<Vec3> field = smooth_field(7, 2, 9);
  ASSERT_EQ(field.size(), expected.size());
  for (std::size_t k = 0; k < field.size(); ++k)
    EXPECT_LT(distance(field[k], expected[k]), 1e-13) << k;
}

TEST(SmoothField, ChangesSlowlyAlongALongChainAndIsOneAtMost) {
  const std::vector<Vec3> field = smooth_field(500, 1, 0);
  double longest = 0.0;
  for (Vec3 direction : field) longest = std::max(longest, norm(direction));
  EXPECT_NEAR(longest, 1.0, 1e-12);
  for (std::size_t k = 1; k < field.size(); ++k) EXPECT_LT(distance(field[k - 1], field[k]), 0.4);
}

TEST(SmoothField, DependsOnSeedAndAttempt) {
  EXPECT_EQ(smooth_field(20, 1, 0), smooth_field(20, 1, 0));
  EXPECT_NE(smooth_field(20, 1, 0), smooth_field(20, 2, 0));
  EXPECT_NE(smooth_field(20, 1, 0), smooth_field(20, 1, 1));
}

}  // namespace pliant::detour_test
