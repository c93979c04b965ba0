// SPDX-License-Identifier: MIT
#include "pliant/fit/saxs/exposure.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/measure/spread_directions.hpp"

namespace pliant {
namespace {

constexpr double water_radius = 1.8;  // Angstrom
constexpr double widest_group = 1.9;

double radius_of(std::uint8_t element) {
  if (element == 7) return 1.7;
  return element == 8 ? 1.6 : widest_group;
}

/// The part of the sphere around a group that is inside of another one: directions along which
/// `axis` is longer than `least`.
struct Cap {
  float x, y, z, least;
};

Cap cap_of(Vec3 between, double squared, double own, double other) {
  const double least = (squared + own * own - other * other) / (2.0 * own);
  return {float(between.x), float(between.y), float(between.z), float(least)};
}

/// Directions by axes, so that several are looked at at once.
struct Directions {
  std::array<float, exposure_points> x{}, y{}, z{};

  Directions() {
    const std::vector<Vec3> all = spread_directions(exposure_points);
    for (std::size_t k = 0; k < exposure_points; ++k) {
      x[k] = float(all[k].x);
      y[k] = float(all[k].y);
      z[k] = float(all[k].z);
    }
  }

  std::uint32_t count_outside(std::span<const Cap> caps) const {
    std::array<std::int32_t, exposure_points> inside{};
    for (const Cap& cap : caps)
      for (std::size_t k = 0; k < exposure_points; ++k)
        inside[k] |= x[k] * cap.x + y[k] * cap.y + z[k] * cap.z > cap.least ? 1 : 0;
    return exposure_points - std::uint32_t(std::accumulate(inside.begin(), inside.end(), 0));
  }
};

}  // namespace

std::vector<std::uint32_t> exposures(std::span<const ScatteringGroup> groups,
                                     std::span<const Vec3> positions) {
  static const Directions directions;
  std::vector<std::vector<Cap>> caps(groups.size());
  const auto radius = [&](std::size_t k) { return radius_of(groups[k].element) + water_radius; };
  CellList(positions, 2.0 * (widest_group + water_radius))
      .for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
        if (std::sqrt(squared) >= radius(i) + radius(j)) return;
        const Vec3 between = positions[j] - positions[i];
        caps[i].push_back(cap_of(between, squared, radius(i), radius(j)));
        caps[j].push_back(cap_of(-between, squared, radius(j), radius(i)));
      });
  std::vector<std::uint32_t> found(groups.size());
  for (std::size_t k = 0; k < groups.size(); ++k) found[k] = directions.count_outside(caps[k]);
  return found;
}

}  // namespace pliant
