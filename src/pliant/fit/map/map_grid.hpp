// SPDX-License-Identifier: MIT
// Where the points of a density map are: a grid along three directions, right-angled or not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "pliant/base/vec3.hpp"
#include "pliant/measure/grid.hpp"

namespace pliant {

/// Point (i, j, k), from 0 to below `count`, is at origin + i steps[0] + j steps[1] + k steps[2]
/// (Angstrom). Values of the points have k running fastest, as those of `points()`.
struct MapGrid {
  std::array<std::size_t, 3> count{};
  Vec3 origin;
  std::array<Vec3, 3> steps{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  Grid points() const { return {count}; }
  std::size_t size() const { return points().size(); }
  Vec3 place(double i, double j, double k) const {
    return origin + i * steps[0] + j * steps[1] + k * steps[2];
  }
  /// Lengths of the steps, Angstrom.
  std::array<double, 3> spacing() const { return {norm(steps[0]), norm(steps[1]), norm(steps[2])}; }
  /// The cosines of the angles between the steps: of 1 and 2, 0 and 2, 0 and 1.
  std::array<double, 3> cosines() const;
  /// Whether the steps are at right angles, to 1e-6.
  bool is_right_angled() const;
};

/// The most points that a map may have.
inline constexpr std::size_t most_map_points = std::size_t{1} << 30;

/// Throws InputError "density map: ..." unless there are 2 points or more along each axis and
/// `most_map_points` at most, numbers are finite, and the steps span space.
void check(const MapGrid& grid);

/// Where a point is, by its number among `points()`.
Vec3 place_of(const MapGrid& grid, std::size_t point);

/// Places in space as places on a grid: (i, j, k), with fractions between points.
class PlacesOnGrid {
 public:
  explicit PlacesOnGrid(const MapGrid& grid);
  Vec3 operator()(Vec3 place) const {
    const Vec3 from = place - origin_;
    return {dot(rows_[0], from), dot(rows_[1], from), dot(rows_[2], from)};
  }
  /// How a place on the grid changes with one in space: the gradients of i, j and k, 1/Angstrom.
  const std::array<Vec3, 3>& rows() const { return rows_; }

 private:
  Vec3 origin_;
  std::array<Vec3, 3> rows_;
};

/// Points of a grid from `low` to below `high` along each axis; it may be empty.
struct GridBox {
  std::array<std::size_t, 3> low{}, high{};
};

/// The box of points around a sphere of a `radius` (Angstrom), clipped to the grid.
GridBox box_around(const MapGrid& grid, const PlacesOnGrid& places, Vec3 center, double radius);

/// Calls visit(point, squared) for the points of the grid within `radius` of a place, in order:
/// `squared` is the square of the distance.
template <class Visit>
void for_each_point_near(const MapGrid& grid, const PlacesOnGrid& places, Vec3 center,
                         double radius, const Visit& visit) {
  const GridBox box = box_around(grid, places, center, radius);
  const Grid points = grid.points();
  for (std::size_t i = box.low[0]; i < box.high[0]; ++i)
    for (std::size_t j = box.low[1]; j < box.high[1]; ++j)
      for (std::size_t k = box.low[2]; k < box.high[2]; ++k) {
        const Vec3 place =
            grid.place(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const double squared = norm_squared(place - center);
        if (squared <= radius * radius) visit(points.at(i, j, k), squared);
      }
}

}  // namespace pliant
