// SPDX-License-Identifier: MIT
#include "pliant/measure/grid.hpp"

#include "pliant/base/random.hpp"
#include "support/test.hpp"

namespace pliant::grid_test {

using Place = std::array<int, 3>;

Place place_of(const Grid& grid, std::size_t point) {
  const std::size_t z = point % grid.count[2], rest = point / grid.count[2];
  return {static_cast<int>(rest / grid.count[1]), static_cast<int>(rest % grid.count[1]),
          static_cast<int>(z)};
}

int squared_between(const Grid& grid, std::size_t one, std::size_t other) {
  const Place a = place_of(grid, one), b = place_of(grid, other);
  int sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

Mask some_of(const Grid& grid, double share, std::uint64_t seed) {
  RandomSequence draws({seed, Domain::generate});
  Mask chosen(grid.size());
  for (std::uint8_t& one : chosen) one = draws.uniform() < share;
  return chosen;
}

TEST(NearestPoints, AreAsNearAsTheNearestOfAll) {
  const Grid grid{{5, 7, 6}};
  for (const double share : {0.02, 0.1, 0.6}) {
    const Mask chosen = some_of(grid, share, 7);
    const NearestPoints nearest = nearest_points(grid, chosen);
    for (std::size_t point = 0; point < grid.size(); ++point) {
      int least = 1000;
      for (std::size_t k = 0; k < grid.size(); ++k)
        if (chosen[k]) least = std::min(least, squared_between(grid, point, k));
      ASSERT_TRUE(chosen[nearest.point[point]]);
      EXPECT_EQ(nearest.squared[point], least);
      EXPECT_EQ(squared_between(grid, point, nearest.point[point]), least);
    }
  }
}

TEST(NearestPoints, AreNoneOfNone) {
  const Grid grid{{2, 3, 4}};
  const NearestPoints nearest = nearest_points(grid, Mask(grid.size(), 0));
  EXPECT_EQ(nearest.point, std::vector<std::int32_t>(24, -1));
}

TEST(Regions, TouchAlongAxesAndAreNumberedByTheirFirstPoints) {
  const Grid grid{{1, 3, 5}};
  const Mask chosen{1, 0, 1, 1, 0,  //
                    0, 1, 0, 1, 0,  //
                    1, 1, 0, 0, 1};
  const std::vector<std::int32_t> expected{1, 0, 2, 2, 0,  //
                                           0, 3, 0, 2, 0,  //
                                           3, 3, 0, 0, 4};
  EXPECT_EQ(regions_of(grid, chosen), expected);
}

}  // namespace pliant::grid_test
