// SPDX-License-Identifier: MIT
#include "pliant/fit/map/density_target.hpp"

#include <cmath>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/fit/map/blurred.hpp"

namespace pliant {
namespace {

constexpr double spread_of_residues = 0.8;  // Angstrom: of atoms about a point of mass

double norm_of(const DensityMap& map) {
  double squares = 0.0;
  for (const double value : map.values()) squares += value * value;
  const std::array<Vec3, 3>& steps = map.grid().steps;
  return std::sqrt(squares * std::abs(dot(steps[0], cross(steps[1], steps[2]))));
}

}  // namespace

DensityTarget::DensityTarget(const DensityMap& map, double background, double resolution,
                             ResidueSites coarse, ResidueSites fine) {
  check_resolution(resolution);
  const DensityMap right = on_right_angles(map);
  const DensityMap above = scaled(right, background, 1.0);
  if (!(above.statistics().greatest > 0.0))
    throw InputError("density map: no value near the molecule is above the background");
  const double sigma = sigma_per_resolution * resolution;
  for (const double times : {2.0, 1.0}) {
    // sigma^2 is the sum of those of map and blur.
    const double more = std::sqrt(times * times - 1.0);
    const DensityMap seen = more > 0.0 ? blurred_by(above, more * sigma) : above;
    const double wide =
        std::sqrt(times * sigma * times * sigma + spread_of_residues * spread_of_residues);
    levels_.push_back(
        {wide, blurred_by(seen, wide), norm_of(seen), std::move(more > 0.0 ? coarse : fine)});
  }
}

}  // namespace pliant
