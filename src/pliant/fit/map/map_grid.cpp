// SPDX-License-Identifier: MIT
#include "pliant/fit/map/map_grid.hpp"

#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

double box_volume(const std::array<Vec3, 3>& steps) {
  return dot(steps[0], cross(steps[1], steps[2]));
}

std::string counts_text(const std::array<std::size_t, 3>& count) {
  return std::to_string(count[0]) + " x " + std::to_string(count[1]) + " x " +
         std::to_string(count[2]);
}

void check_counts(const std::array<std::size_t, 3>& count) {
  if (*std::min_element(count.begin(), count.end()) < 2)
    throw InputError("density map: expected 2 points or more along each axis, found " +
                     counts_text(count));
  const double all =
      static_cast<double>(count[0]) * static_cast<double>(count[1]) * static_cast<double>(count[2]);
  if (all > static_cast<double>(most_map_points))
    throw InputError("density map: expected " + std::to_string(most_map_points) +
                     " points at most, found " + counts_text(count));
}

/// A place on a grid as the number of a point there or beyond, from 0 to `count`.
std::size_t clipped(double place, std::size_t count) {
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count)));
}

}  // namespace

std::array<double, 3> MapGrid::cosines() const {
  const auto [a, b, c] = spacing();
  return {dot(steps[1], steps[2]) / (b * c), dot(steps[0], steps[2]) / (a * c),
          dot(steps[0], steps[1]) / (a * b)};
}

bool MapGrid::is_right_angled() const {
  const std::array<double, 3> all = cosines();
  return std::all_of(all.begin(), all.end(), [](double one) { return std::abs(one) < 1e-6; });
}

void check(const MapGrid& grid) {
  check_counts(grid.count);
  const auto [a, b, c] = grid.spacing();
  const double volume = std::abs(box_volume(grid.steps));
  const bool is_sound = is_finite(grid.origin) && std::min({a, b, c}) >= 1e-3 &&
                        std::max({a, b, c}) <= 1e4 && volume > 0.1 * a * b * c;
  if (!is_sound)
    throw InputError(
        "density map: expected a finite origin, and steps from 0.001 to 10000 Angstrom that are "
        "not nearly in one plane");
}

Vec3 place_of(const MapGrid& grid, std::size_t point) {
  const std::size_t row = point / grid.count[2];
  return grid.place(static_cast<double>(row / grid.count[1]),
                    static_cast<double>(row % grid.count[1]),
                    static_cast<double>(point % grid.count[2]));
}

PlacesOnGrid::PlacesOnGrid(const MapGrid& grid) : origin_(grid.origin) {
  const double inverse = 1.0 / box_volume(grid.steps);
  for (std::size_t k = 0; k < 3; ++k)
    rows_[k] = inverse * cross(grid.steps[(k + 1) % 3], grid.steps[(k + 2) % 3]);
}

GridBox box_around(const MapGrid& grid, const PlacesOnGrid& places, Vec3 center, double radius) {
  const Vec3 middle = places(center);
  const std::array<double, 3> at{middle.x, middle.y, middle.z};
  GridBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double reach = radius * norm(places.rows()[k]);
    box.low[k] = clipped(std::ceil(at[k] - reach), grid.count[k]);
    box.high[k] = clipped(std::floor(at[k] + reach) + 1.0, grid.count[k]);
  }
  return box;
}

}  // namespace pliant
