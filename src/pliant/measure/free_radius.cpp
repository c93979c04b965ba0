// SPDX-License-Identifier: MIT
#include "pliant/measure/free_radius.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

/// The points along an axis within `reach` of a place, and the squares of their distances.
struct Along {
  Along(double place, double reach, std::size_t count) {
    const double low = std::max(std::ceil(place - reach), 0.0);
    const double high = std::min(std::floor(place + reach), static_cast<double>(count) - 1.0);
    if (high < low) return;
    first = static_cast<std::size_t>(low);
    for (double at = low; at <= high; ++at) {
      const auto apart = static_cast<float>(at - place);
      squared.push_back(apart * apart);
    }
  }

  std::size_t first = 0;
  std::vector<float> squared;
};

/// Lowers the square of the distance to the nearest atom (steps^2) of the points around one.
void lower_around(Vec3 place, double reach, const Grid& grid, std::vector<float>& nearest) {
  const Along x(place.x, reach, grid.count[0]), y(place.y, reach, grid.count[1]),
      z(place.z, reach, grid.count[2]);
  const std::size_t length = z.squared.size();
  for (std::size_t i = 0; i < x.squared.size(); ++i)
    for (std::size_t j = 0; j < y.squared.size(); ++j) {
      float* row = &nearest[grid.at(x.first + i, y.first + j, z.first)];
      for (std::size_t k = 0; k < length; ++k)
        row[k] = std::min(row[k], x.squared[i] + (y.squared[j] + z.squared[k]));
    }
}

}  // namespace

std::vector<float> free_radii(const Grid& grid, std::span<const Vec3> places,
                              std::span<const double> radii, double most) {
  std::vector<float> clear(grid.size(), static_cast<float>(most));
  std::vector<double> sizes(radii.begin(), radii.end());
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  std::vector<float> nearest;
  for (const double size : sizes) {  // of atoms of one size the nearest counts: one root a point
    nearest.assign(grid.size(), std::numeric_limits<float>::infinity());
    for (std::size_t k = 0; k < places.size(); ++k)
      if (radii[k] == size) lower_around(places[k], size + most, grid, nearest);
    const auto radius = static_cast<float>(size);
    for (std::size_t k = 0; k < clear.size(); ++k)
      if (std::isfinite(nearest[k])) clear[k] = std::min(clear[k], std::sqrt(nearest[k]) - radius);
  }
  return clear;
}

Mask covered(const Grid& grid, const Mask& centres, std::span<const float> radius, double step) {
  const NearestPoints nearest = nearest_points(grid, centres);
  Mask found(grid.size(), 0);
  for (std::size_t k = 0; k < grid.size(); ++k)
    found[k] = nearest.point[k] >= 0 && std::sqrt(static_cast<double>(nearest.squared[k])) * step <=
                                            radius[nearest.point[k]];
  return found;
}

}  // namespace pliant
