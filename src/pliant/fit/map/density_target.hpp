// SPDX-License-Identifier: MIT
// A density map that a fit is to explain, coarse and fine.
#pragma once

#include <vector>

#include "pliant/fit/map/density_map.hpp"
#include "pliant/fit/residue_sites.hpp"

namespace pliant {

/// A map at some resolution, prepared for correlations with Gaussians of that resolution.
struct DensityLevel {
  double sigma = 0.0;    ///< Angstrom, of a Gaussian at a point of mass
  DensityMap convolved;  ///< the map convolved with it
  double norm = 0.0;     ///< root of the integral of the square of the map
  ResidueSites sites;    ///< points of mass
};

/// A map and the mass that is to explain it, a Gaussian at each point of mass: at twice the
/// resolution, and at the resolution.
class DensityTarget {
 public:
  /// Density below `background` counts as none. Throws InputError if the map is nowhere above
  /// that, OptionError as check_resolution() does.
  DensityTarget(const DensityMap& map, double background, double resolution, ResidueSites coarse,
                ResidueSites fine);

  const DensityLevel& coarse() const { return levels_[0]; }
  const DensityLevel& fine() const { return levels_[1]; }
  std::size_t node_count() const { return fine().sites.node_count(); }

 private:
  std::vector<DensityLevel> levels_;
};

}  // namespace pliant
