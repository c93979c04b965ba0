// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/near/near_hits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace pliant {
namespace near_hits_test {

struct Points {
  std::vector<float> x, y, z;
};

Points random_points(std::uint32_t count) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<float>(random() % 10000) * 1e-3F; };
  Points points;
  for (std::uint32_t k = 0; k < count; ++k) {
    points.x.push_back(coordinate());
    points.y.push_back(coordinate());
    points.z.push_back(coordinate());
  }
  return points;
}

float square_of(const Points& points, std::uint32_t a, std::uint32_t b) {
  const float x = points.x[a] - points.x[b], y = points.y[a] - points.y[b],
              z = points.z[a] - points.z[b];
  return x * x + y * y + z * z;
}

TEST(NearHits, AreThoseOfEachDistanceInRunsOfAnyLength) {
  const Points points = random_points(40 + points_beyond);
  const float widest = 25.0F;
  for (const FindNearHits find : near_hits_finders())
    for (std::uint32_t from = 0; from < 8; ++from)
      for (std::uint32_t to = from; to <= 40; ++to) {
        std::vector<float> squares(40 + points_beyond);
        const std::array<NearRun, 2> runs{NearRun{from, to}, NearRun{0, from / 2}};
        std::vector<std::uint32_t> hits(to - from + from / 2 + hits_beyond), expected;
        const NearPoints arrays{points.x.data(), points.y.data(), points.z.data()};
        hits.resize(find(arrays, runs, 11, widest, squares.data(), hits.data()));
        for (const NearRun run : runs)
          for (std::uint32_t m = run.from; m < run.to; ++m) {
            EXPECT_EQ(squares[m], square_of(points, m, 11));
            if (squares[m] < widest) expected.push_back(m);
          }
        EXPECT_EQ(hits, expected) << from << " to " << to;
      }
}

}  // namespace near_hits_test
}  // namespace pliant
