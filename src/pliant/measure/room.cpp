// SPDX-License-Identifier: MIT
#include "pliant/measure/room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pliant/measure/convex_hull.hpp"
#include "pliant/measure/enclosed.hpp"
#include "pliant/measure/free_radius.hpp"
#include "pliant/measure/grid.hpp"

namespace pliant {
namespace {

/// Places along an axis, a step apart, from below `low` to below `high`.
std::vector<double> places_along(double low, double high, double step, double offset) {
  const double first = low + (offset - 1.0) * step;
  const auto count = static_cast<std::size_t>(std::ceil((high - first) / step));
  const double apart = (first + step) - first;
  std::vector<double> places(count);
  for (std::size_t k = 0; k < count; ++k) places[k] = first + static_cast<double>(k) * apart;
  return places;
}

/// A grid around the hull of lining atoms.
class HullGrid {
 public:
  HullGrid(std::span<const Vec3> lining, double step, double offset)
      : planes_(convex_hull(lining)), step_(step) {
    const auto [low, high] = extent_of(lining);
    const auto along = [&](double from, double to) {
      return places_along(from - small_probe, to + small_probe, step, offset);
    };
    places_ = {along(low.x, high.x), along(low.y, high.y), along(low.z, high.z)};
    grid_.count = {places_[0].size(), places_[1].size(), places_[2].size()};
    if (!planes_.empty()) measure_heights();
  }

  bool is_flat() const { return planes_.empty(); }
  const Grid& grid() const { return grid_; }
  double step() const { return step_; }

  /// The points no further than `most` above the planes of the hull (Angstrom).
  Mask within(double most) const {
    Mask found(heights_.size());
    for (std::size_t k = 0; k < found.size(); ++k) found[k] = heights_[k] <= most;
    return found;
  }

  /// The radius of the sphere about each point that touches no atom, Angstrom.
  std::vector<float> radii_without(std::span<const Vec3> positions,
                                   std::span<const double> radii) const {
    const double most = large_probe + step_;
    std::vector<Vec3> places;
    std::vector<double> sizes;
    for (std::size_t k = 0; k < positions.size(); ++k) {
      if (!is_near(positions[k], most + radii[k])) continue;
      places.push_back((1.0 / step_) * (positions[k] - point(0, 0, 0)));
      sizes.push_back(radii[k] / step_);
    }
    std::vector<float> found = free_radii(grid_, places, sizes, most / step_);
    for (float& radius : found) radius *= static_cast<float>(step_);
    return found;
  }

  /// The places of some points.
  std::vector<Vec3> points(const Mask& chosen) const {
    std::vector<Vec3> found;
    std::size_t k = 0;
    for (std::size_t x = 0; x < grid_.count[0]; ++x)
      for (std::size_t y = 0; y < grid_.count[1]; ++y)
        for (std::size_t z = 0; z < grid_.count[2]; ++z, ++k)
          if (chosen[k]) found.push_back(point(x, y, z));
    return found;
  }

 private:
  Vec3 point(std::size_t x, std::size_t y, std::size_t z) const {
    return {places_[0][x], places_[1][y], places_[2][z]};
  }

  bool is_near(Vec3 p, double reach) const {
    const auto inside = [&](double at, const std::vector<double>& places) {
      return at >= places.front() - reach && at <= places.back() + reach;
    };
    return inside(p.x, places_[0]) && inside(p.y, places_[1]) && inside(p.z, places_[2]);
  }

  /// The height above the plane that is furthest below.
  void measure_heights() {
    heights_.assign(grid_.size(), -std::numeric_limits<double>::infinity());
    const std::vector<double>& zs = places_[2];
    for (std::size_t x = 0; x < grid_.count[0]; ++x)
      for (std::size_t y = 0; y < grid_.count[1]; ++y)
        for (const Plane& plane : planes_) {
          double* row = &heights_[grid_.at(x, y, 0)];
          const double along = plane.normal.x * places_[0][x] + plane.normal.y * places_[1][y];
          for (std::size_t z = 0; z < zs.size(); ++z)
            row[z] = std::max(row[z], along + plane.normal.z * zs[z] + plane.offset);
        }
  }

  std::vector<Plane> planes_;
  double step_;
  std::array<std::vector<double>, 3> places_;
  Grid grid_;
  std::vector<double> heights_;  ///< of the points above the hull, Angstrom; inside below 0
};

/// Room for a small probe within the hull, whose centre may be just outside.
Mask room_in(const HullGrid& hull, std::span<const Vec3> positions, std::span<const double> radii) {
  const std::vector<float> free = hull.radii_without(positions, radii);
  Mask centres = hull.within(small_probe);
  for (std::size_t k = 0; k < centres.size(); ++k)
    centres[k] = centres[k] && free[k] >= static_cast<float>(small_probe);
  Mask room = covered(hull.grid(), centres, free, hull.step());
  const Mask inside = hull.within(0.0);
  for (std::size_t k = 0; k < room.size(); ++k) room[k] = room[k] && inside[k];
  return room;
}

}  // namespace

Room room_among(std::span<const Vec3> positions, std::span<const double> radii,
                std::span<const std::uint32_t> lining, double step, double offset) {
  std::vector<Vec3> corners;
  for (const std::uint32_t atom : lining) corners.push_back(positions[atom]);
  const HullGrid hull(corners, step, offset);
  if (hull.is_flat()) return {};
  const std::vector<Vec3> room = hull.points(room_in(hull, positions, radii));
  const double volume = step * step * step;
  return {static_cast<double>(room.size()) * volume,
          static_cast<double>(count_enclosed(room, positions, radii)) * volume};
}

}  // namespace pliant
