// SPDX-License-Identifier: MIT
// A molecule put into a map as a rigid body.
#pragma once

#include <span>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// How a molecule was put into a map.
struct Placing {
  RigidMotion motion;    ///< moves the positions into the map
  double density = 0.0;  ///< the mean at the atoms, by weight; the map's greatest value is 1
};

/// The rigid motion into a map of some `resolution` that makes the sum of weight x density at the
/// positions greatest, as far as a search finds it; wherever the molecule was before.
/// Deterministic.
///
/// In the map blurred to twice the resolution, rotations that are spread evenly are tried about the
/// center of density and other places in density; the best go uphill there, and then in the map as
/// it is. A map much larger than the molecule has places for which this is too coarse. Throws
/// InputError for fewer than three positions, positions that are not finite, weights that are not
/// as many and above 0, and where density_pyramid() does; OptionError as check_resolution() does.
Placing place_in_map(const DensityMap& map, std::span<const Vec3> positions,
                     std::span<const double> weights, double resolution);

/// The rigid motion from `start` uphill to a summit of the sum of weight x density at the
/// positions, in the map as it is: the density is in its unit. Throws as place_in_map() does for
/// positions.
Placing climb_in_map(const DensityMap& map, std::span<const Vec3> positions,
                     std::span<const double> weights, const RigidMotion& start);

}  // namespace pliant
