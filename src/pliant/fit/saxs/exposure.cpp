// SPDX-License-Identifier: MIT
#include "pliant/fit/saxs/exposure.hpp"

#include <utility>

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

/// The sphere of another group, as seen from a group.
struct Sphere {
  Vec3 center;
  double squared;  ///< of its radius, Angstrom^2
};

bool is_inside(Vec3 point, const Sphere& sphere) {
  return norm_squared(point - sphere.center) < sphere.squared;
}

/// Spheres that hold a point move to the front: they hold the next ones most often.
std::uint32_t count_outside(std::span<const Vec3> directions, double radius,
                            std::span<Sphere> spheres) {
  std::uint32_t outside = 0;
  for (const Vec3 direction : directions) {
    const Vec3 point = radius * direction;
    std::size_t k = 0;
    while (k < spheres.size() && !is_inside(point, spheres[k])) ++k;
    if (k == spheres.size()) {
      ++outside;
    } else {
      std::swap(spheres[k], spheres[k / 2]);
    }
  }
  return outside;
}

}  // namespace

std::vector<std::uint32_t> exposures(std::span<const ScatteringGroup> groups,
                                     std::span<const Vec3> positions) {
  static const std::vector<Vec3> directions = spread_directions(exposure_points);
  std::vector<std::vector<Sphere>> near(groups.size());
  const auto radius = [&](std::size_t k) { return radius_of(groups[k].element) + water_radius; };
  CellList(positions, 2.0 * (widest_group + water_radius))
      .for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
        const double reach = radius(i) + radius(j);
        if (squared >= reach * reach) return;
        const Vec3 between = positions[j] - positions[i];
        near[i].push_back({between, radius(j) * radius(j)});
        near[j].push_back({-between, radius(i) * radius(i)});
      });
  std::vector<std::uint32_t> found(groups.size());
  for (std::size_t k = 0; k < groups.size(); ++k)
    found[k] = count_outside(directions, radius(k), near[k]);
  return found;
}

}  // namespace pliant
