// SPDX-License-Identifier: MIT
// The map that atoms would have at a resolution.
#pragma once

#include <span>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// Right-angled grid around `positions` with a margin of 5 sigma and the same `spacing` (Angstrom)
/// along each axis, from a point whose coordinates are whole multiples of it. Throws InputError
/// for no positions, and positions that are not finite; OptionError for a spacing out of
/// 0.05 to 100.
MapGrid grid_around(std::span<const Vec3> positions, double resolution, double spacing);

/// The usual spacing of a map at a resolution.
constexpr double usual_spacing(double resolution) { return resolution / 4.0; }

/// The sum over atoms of `weight` exp(-d^2 / 2 sigma^2), cut off beyond 5 sigma along each axis of
/// the grid, in linear time. Weights are atomic numbers as a rule. Throws InputError if there is
/// not one weight for each position, or a number is not finite; OptionError as check_resolution()
/// does.
DensityMap simulated(const MapGrid& grid, std::span<const Vec3> positions,
                     std::span<const double> weights, double resolution);

}  // namespace pliant
