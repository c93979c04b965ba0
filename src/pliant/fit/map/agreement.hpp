// SPDX-License-Identifier: MIT
// How well a map agrees with what atoms would have at its resolution.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// The usual distance within which points of a map count as near to an atom, Angstrom.
constexpr double usual_mask_radius(double resolution) { return std::max(3.0, 0.5 * resolution); }

/// Correlations (Pearson's, about the means) of a map and the one simulated for atoms, at points
/// near to atoms. 0 where one of both is the same everywhere.
class MapAgreement {
 public:
  /// Takes a map, atoms as simulated() does, and how near a point must be to count (Angstrom).
  /// The map must outlive this. Throws as simulated() does, and OptionError unless the radius is
  /// above 0 and at most 100.
  MapAgreement(const DensityMap& map, std::span<const Vec3> positions,
               std::span<const double> weights, double resolution, double radius);

  /// At points near to any atom. Throws InputError if there are none: the atoms are outside of the
  /// map.
  double overall() const;
  /// At points near to the atoms of each group: `group_of` (one for each atom) is below `groups`.
  /// 0 for groups with fewer than two points.
  std::vector<double> by_group(std::span<const std::uint32_t> group_of, std::size_t groups) const;

 private:
  void gather(Vec3 position, std::vector<std::uint8_t>& seen,
              std::vector<std::size_t>& points) const;
  double correlation_at(std::span<const std::size_t> points) const;

  const DensityMap& map_;
  std::vector<Vec3> positions_;
  DensityMap expected_;
  double radius_;
};

}  // namespace pliant
