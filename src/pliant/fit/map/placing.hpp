// SPDX-License-Identifier: MIT
// A molecule put into a map as a rigid body.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// How a molecule was put into a map.
struct Placing {
  RigidMotion motion;    ///< moves the positions into the map
  double density = 0.0;  ///< the mean at the atoms, by weight; the map's greatest value is 1
};

/// The rigid motions into a map of some `resolution` at which the sum of weight x density at the
/// positions is greatest, as far as a search finds them: `most` summits at most, densest first,
/// wherever the molecule was before. Deterministic.
///
/// In the map blurred to twice the resolution, rotations that are spread evenly are tried about the
/// center of density and other places in density; the best go uphill there, and then in the map as
/// it is. A map much larger than the molecule has places for which this is too coarse. Throws
/// InputError for fewer than three positions, positions that are not finite, weights that are not
/// as many and above 0, and where density_pyramid() does; OptionError as check_resolution() does.
std::vector<Placing> place_in_map(const DensityMap& map, std::span<const Vec3> positions,
                                  std::span<const double> weights, double resolution,
                                  std::size_t most = 1);

}  // namespace pliant
