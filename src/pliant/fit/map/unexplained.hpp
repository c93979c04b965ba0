// SPDX-License-Identifier: MIT
// Density of a map that no atom is near to.
#pragma once

#include <span>
#include <vector>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// Density in one piece.
struct DensityBlob {
  Vec3 center;         ///< of its density, Angstrom
  double share = 0.0;  ///< of all density above the threshold
};

struct UnexplainedDensity {
  double share = 0.0;              ///< of all density above the threshold, from 0 to 1
  std::vector<DensityBlob> blobs;  ///< the largest, largest first
};

/// The usual threshold: two deviations above the mean of the map.
double usual_threshold(const DensityMap& map);

/// What is above `threshold` (counted from there) at points that are further than `radius`
/// (Angstrom) from every position: its share, and its `most_blobs` largest pieces, whose points
/// touch along axes. Throws OptionError where no value is above the threshold, and for a radius
/// that is not above 0 and at most 100.
UnexplainedDensity unexplained_density(const DensityMap& map, std::span<const Vec3> positions,
                                       double threshold, double radius = 3.0,
                                       std::size_t most_blobs = 5);

}  // namespace pliant
