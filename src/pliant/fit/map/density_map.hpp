// SPDX-License-Identifier: MIT
// A density map: values at the points of a grid, and what is between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/fit/map/map_grid.hpp"

namespace pliant {

/// A resolution as the width of a Gaussian: sigma = 0.225 x resolution, as EMAN and ChimeraX'
/// molmap take it (its Fourier transform falls to 1/e at 1/resolution).
inline constexpr double sigma_per_resolution = 0.225;

/// Throws OptionError "resolution = 0: must be from 0.5 to 200 (Angstrom)".
void check_resolution(double resolution);

/// What a map is at some place.
struct DensityAt {
  double value = 0.0;
  Vec3 gradient;  ///< of the value, 1/Angstrom
  bool is_inside = false;
};

/// What a map is at some places.
struct DensitiesAt {
  std::vector<double> values;
  std::vector<Vec3> gradients;  ///< 1/Angstrom
  std::size_t outside = 0;      ///< how many places are outside of the box of the map
};

/// The mean of the values of a map, their standard deviation, and their range.
struct MapStatistics {
  double mean = 0.0, deviation = 0.0, least = 0.0, greatest = 0.0;
};

/// Values at the points of a grid, in any unit; they do not change.
class DensityMap {
 public:
  /// Takes one value for each point of `grid`. Throws InputError if there are not so many, if one
  /// is not finite, or as check(grid) does.
  DensityMap(const MapGrid& grid, std::vector<float> values);

  const MapGrid& grid() const { return grid_; }
  const PlacesOnGrid& places() const { return places_; }
  std::span<const float> values() const { return values_; }

  /// The value between the eight points around a place (linear along each axis) and its exact
  /// gradient there. Outside of the box of the points both are 0.
  DensityAt at(Vec3 place) const;
  DensitiesAt at(std::span<const Vec3> places) const;

  MapStatistics statistics() const;

 private:
  MapGrid grid_;
  PlacesOnGrid places_;
  std::vector<float> values_;
};

/// "3 that are not, the first at point 0, 1, 2", if values are not finite; "" if all are.
std::string not_finite_text(const Grid& points, std::span<const float> values);

/// The map with (value - shift) / unit for each value.
DensityMap scaled(const DensityMap& map, double shift, double unit);

/// The part of a map within `margin` (Angstrom) of positions, along each axis. Throws InputError
/// where no point of the map is so near: "the molecule lies outside of the map".
DensityMap cropped(const DensityMap& map, std::span<const Vec3> positions, double margin);

/// The median of the values: what is around a molecule, as a rule.
double median(const DensityMap& map);

/// The map with mean 0 and deviation 1. Throws InputError if all values are equal.
DensityMap normalized(const DensityMap& map);

}  // namespace pliant
