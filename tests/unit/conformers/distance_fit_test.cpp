// SPDX-License-Identifier: MIT
// Steps towards given distances: in lanes the same bits as one by one, on every level.
#include "pliant/conformers/rings/distance_fit.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/resolve/lanes/lane_kernels.hpp"
#include "support/test.hpp"

namespace pliant {
namespace {

constexpr int steps = 5;
constexpr double damped = 0.05;
constexpr std::size_t points = 9, alike = 3;  // all points of lane 3 are one

using Starts = std::array<std::vector<Vec3>, lane_count>;

/// Distances of a cloud of points: of each to the next `apart` ones.
std::vector<WantedDistance> distances(std::size_t apart) {
  std::vector<WantedDistance> wanted;
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t j = i + 1; j <= i + apart && j < points; ++j)
      wanted.push_back({j % 2 == 0 ? j : i, j % 2 == 0 ? i : j, 1.0 + 0.3 * double(j - i)});
  return wanted;
}

Starts random_starts() {
  RandomSequence draws({7, Domain::torsion, 0, 0, 0});
  Starts starts;
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    for (std::size_t k = 0; k < points; ++k)
      starts[lane].push_back(lane == alike ? Vec3{1.0, 2.0, 3.0} : 2.0 * draws.direction());
  return starts;
}

LaneMask in_lanes(const LaneKernels& kernels, const std::vector<WantedDistance>& wanted,
                  Starts& starts) {
  std::vector<LaneDistance> list;
  for (const auto& [i, j, square] : wanted)
    list.push_back({std::uint32_t(i), std::uint32_t(j), square});
  std::vector<LaneValue> room(approach_room(list.size(), points));
  std::vector<LaneVector> x(points);
  std::array<double*, lane_count> rows{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) rows[lane] = &starts[lane][0].x;
  kernels.gather(rows.data(), 3 * points, &x[0].x);
  const LaneMask solved =
      kernels.approach({list.data(), list.size()}, points, damped, steps, room.data(), x.data());
  kernels.scatter(&x[0].x, 3 * points, rows.data());
  return solved;
}

class DistanceFit : public testing::TestWithParam<std::size_t> {};

TEST_P(DistanceFit, StepsInLanesAreThoseOfOneByOne) {
  const std::vector<WantedDistance> wanted = distances(GetParam());
  Starts alone = random_starts();
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    for (int step = 0; step < steps; ++step)
      ASSERT_EQ(approach(wanted, damped, alone[lane]) == HUGE_VAL, lane == alike);
  for (const LaneKernels* const kernels : lane_levels()) {
    Starts together = random_starts();
    EXPECT_EQ(in_lanes(*kernels, wanted, together), all_lanes & ~(1 << alike)) << kernels->level;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (lane != alike) EXPECT_EQ(together[lane], alone[lane]) << kernels->level << lane;
  }
}

// 15 distances are fewer than 27 coordinates, 30 are more.
INSTANTIATE_TEST_SUITE_P(FewAndMany, DistanceFit, testing::Values(2, 5));

}  // namespace
}  // namespace pliant
