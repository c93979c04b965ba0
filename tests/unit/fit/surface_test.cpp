// SPDX-License-Identifier: MIT
// Surfaces of maps: closed, and of the volume and the area of a ball where the map is a Gaussian.
#include "pliant/fit/map/surface.hpp"

#include <map>

#include "pliant/base/random.hpp"
#include "support/test.hpp"

namespace pliant::surface_test {

using test::error_text;

constexpr double pi = 3.14159265358979;

/// exp(-r^2 / 2) about a place that no point of the grid is at.
DensityMap ball_on(const std::array<Vec3, 3>& steps) {
  MapGrid grid;
  grid.count = {40, 40, 40};
  grid.steps = steps;
  grid.origin = Vec3{0.3, 7.0, -2.0} - grid.place(19.4, 19.7, 19.2);
  std::vector<float> values;
  for (std::size_t point = 0; point < grid.size(); ++point)
    values.push_back(static_cast<float>(
        std::exp(-0.5 * norm_squared(place_of(grid, point) - Vec3{0.3, 7.0, -2.0}))));
  return {grid, std::move(values)};
}

DensityMap noise() {
  MapGrid grid;
  grid.count = {9, 10, 11};
  RandomSequence draws({4, Domain::generate});
  std::vector<float> values;
  for (std::size_t point = 0; point < grid.size(); ++point)
    values.push_back(static_cast<float>(draws.uniform()));
  return {grid, std::move(values)};
}

/// Whether each edge is gone along as often one way as the other.
bool is_closed(const Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const auto& corners : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      count[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  return std::ranges::all_of(count, [](const auto& row) { return row.second == 0; });
}

/// Volume inside (above 0 where triangles face outwards) and area.
std::pair<double, double> size_of(const Surface& surface) {
  double volume = 0.0, area = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& x = surface.vertices;
    volume += dot(x[a], cross(x[b], x[c])) / 6.0;
    area += norm(cross(x[b] - x[a], x[c] - x[a])) / 2.0;
  }
  return {volume, area};
}

TEST(Surface, OfAGaussianIsABall) {
  const std::array<Vec3, 3> straight{Vec3{0.15, 0, 0}, Vec3{0, 0.15, 0}, Vec3{0, 0, 0.15}},
      skewed{Vec3{0.15, 0, 0}, Vec3{-0.04, 0.16, 0}, Vec3{0.03, 0.02, 0.17}},
      mirrored{Vec3{0, 0.15, 0}, Vec3{0.15, 0, 0}, Vec3{0, 0, 0.15}};
  for (const auto& steps : {straight, skewed, mirrored}) {
    const Surface found = surface_of(ball_on(steps), std::exp(-0.5 * 1.5 * 1.5));
    const auto [volume, area] = size_of(found);
    EXPECT_TRUE(is_closed(found));
    EXPECT_NEAR(volume / (4.0 / 3.0 * pi * 1.5 * 1.5 * 1.5), 1.0, 0.015);
    EXPECT_NEAR(area / (4.0 * pi * 1.5 * 1.5), 1.0, 0.015);
    // Euler: a ball has no handles.
    EXPECT_EQ(2 * found.vertices.size(), found.triangles.size() + 4);
  }
}

TEST(Surface, IsClosedWhateverTheMap) {
  for (const double level : {-1.0, 0.1, 0.5, 0.9}) {
    const Surface found = surface_of(noise(), level);
    EXPECT_FALSE(found.triangles.empty());
    EXPECT_TRUE(is_closed(found));
    EXPECT_GT(size_of(found).first, 0.0);
    for (const Vec3 vertex : found.vertices)
      for (const auto& [x, most] : {std::pair{vertex.x, 8.0}, {vertex.y, 9.0}, {vertex.z, 10.0}})
        ASSERT_TRUE(x >= 0.0 && x <= most);
  }
}

TEST(Surface, OfAllOfAMapIsItsBox) {
  const auto [volume, area] = size_of(surface_of(noise(), 0.0));
  EXPECT_LT(std::abs(volume / (8.0 * 9.0 * 10.0) - 1.0), 0.1);
  EXPECT_LT(std::abs(area / (2 * (72.0 + 80.0 + 90.0)) - 1.0), 0.1);
}

TEST(Surface, IsRefusedWhereThereIsNone) {
  for (const double level : {1.0, double{NAN}, double{-INFINITY}})
    EXPECT_THROW((void)surface_of(noise(), level), OptionError);
  EXPECT_EQ(error_text<OptionError>([] { (void)level_around(noise(), 0.0); }),
            "volume = 0: must be above 0 and at most that of the map, 990");
  EXPECT_THROW((void)level_around(noise(), 991.0), OptionError);
}

TEST(LevelAround, EnclosesThatVolume) {
  const DensityMap map = ball_on({Vec3{0.15, 0, 0}, Vec3{0, 0.15, 0}, Vec3{0, 0, 0.15}});
  const double volume = 4.0 / 3.0 * pi * 2.0 * 2.0 * 2.0;
  EXPECT_NEAR(level_around(map, volume), std::exp(-2.0), 2e-3);
  EXPECT_EQ(level_around(map, 1e-9), map.statistics().greatest);
}

}  // namespace pliant::surface_test
