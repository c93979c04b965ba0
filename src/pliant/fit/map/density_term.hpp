// SPDX-License-Identifier: MIT
// A density map as a term of an energy.
#pragma once

#include <memory>
#include <span>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// Minus the sum of the density at points: low where points are in density.
class DensityTerm {
 public:
  explicit DensityTerm(DensityMap map);

  /// Returns -weight x the sum of the map's values at `x` (Angstrom), and adds its gradient to
  /// `gradient` (one for each point). Points outside of the map add nothing. Copies share the map.
  double add(std::span<const Vec3> x, double weight, std::span<Vec3> gradient) const;

  const DensityMap& map() const { return *map_; }

 private:
  std::shared_ptr<const DensityMap> map_;
};

}  // namespace pliant
