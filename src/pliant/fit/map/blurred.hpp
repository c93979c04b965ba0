// SPDX-License-Identifier: MIT
// Maps at a lower resolution.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// The map on a right-angled grid around its own, with as many points in a volume, by linear
/// interpolation; 0 outside of its box. A map on such a grid is given back as it is.
DensityMap on_right_angles(const DensityMap& map);

/// The map convolved with a Gaussian of sigma = 0.225 x resolution, of sum 1 and cut off beyond
/// 5 sigma; outside of its box a map is 0. The blur adds to what the map has: sigma^2 is the sum of
/// both. A map on a skewed grid is put onto right angles first. Linear in points and in sigma.
/// Throws OptionError as check_resolution() does.
DensityMap blurred(const DensityMap& map, double resolution);
/// The same for a Gaussian of that sigma (Angstrom).
DensityMap blurred_by(const DensityMap& map, double sigma);

/// A map of some `resolution` from coarse to fine, each with its greatest value 1: at
/// 2^(levels - 1) times that resolution, ..., twice, and as it is. Throws OptionError as
/// check_resolution() does, InputError if the map is nowhere above 0.
std::vector<DensityMap> density_pyramid(const DensityMap& map, double resolution,
                                        std::size_t levels = 2);

}  // namespace pliant
