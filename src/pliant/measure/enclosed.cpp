// SPDX-License-Identifier: MIT
#include "pliant/measure/enclosed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/measure/grid.hpp"
#include "pliant/measure/spread_directions.hpp"

namespace pliant {
namespace {

constexpr int ray_reach = 8;  ///< Angstrom
constexpr std::size_t ray_count = 30;
constexpr double ray_cell = 1.0;  ///< Angstrom

using Rays = std::array<Vec3, ray_count>;

Rays spread_rays() {
  Rays rays;
  std::ranges::copy(spread_directions(ray_count), rays.begin());
  return rays;
}

/// To the nearest integer, of two the even one, for what is far below 2^51.
inline double rounded_to_even(double x) {
  constexpr double large = 6755399441055744.0;  // 1.5 * 2^52: no digit behind the point is left
  return (x + large) - large;
}

/// Cells of a grid whose middles are in an atom, around some points.
class FilledCells {
 public:
  FilledCells(std::span<const Vec3> points, std::span<const Vec3> positions,
              std::span<const double> radii) {
    const double margin = ray_reach + *std::ranges::max_element(radii) + ray_cell;
    const Extent extent = extent_of(points);
    const Vec3 beside{margin, margin, margin};
    low_ = extent.low - beside;
    const Vec3 size = extent.high + beside - low_;
    grid_.count = {cells_in(size.x), cells_in(size.y), cells_in(size.z)};
    filled_.assign(grid_.size(), 0);
    for (std::size_t k = 0; k < positions.size(); ++k) fill(positions[k] - low_, radii[k]);
  }

  bool is_enclosed(Vec3 point, const Rays& rays) const {
    const Vec3 place = point - low_;
    std::size_t met = 0;
    for (std::size_t k = 0; k < ray_count; ++k) {
      if (2 * (met + ray_count - k) < ray_count) return false;
      met += is_met(place, rays[k]);
      if (2 * met >= ray_count) return true;
    }
    return false;
  }

 private:
  static std::size_t cells_in(double length) {
    return static_cast<std::size_t>(std::ceil(length / ray_cell)) + 1;
  }

  bool is_met(Vec3 place, Vec3 direction) const {
    for (int length = 1; length <= ray_reach; ++length) {
      const Vec3 at = place + static_cast<double>(length) * direction;
      if (filled_[grid_.at(static_cast<std::size_t>(rounded_to_even(at.x)),
                           static_cast<std::size_t>(rounded_to_even(at.y)),
                           static_cast<std::size_t>(rounded_to_even(at.z)))])
        return true;
    }
    return false;
  }

  bool is_in(Vec3 place) const {
    const auto inside = [](double at, std::size_t count) {
      return at > 0.0 && at < static_cast<double>(count);
    };
    return inside(place.x, grid_.count[0]) && inside(place.y, grid_.count[1]) &&
           inside(place.z, grid_.count[2]);
  }

  /// Cells along an axis that an atom may reach: [first, last].
  static std::array<std::size_t, 2> range(double place, double radius, std::size_t count) {
    const double low = std::max(std::ceil(place - radius), 0.0);
    const double high = std::min(std::floor(place + radius), static_cast<double>(count) - 1.0);
    return {static_cast<std::size_t>(low), static_cast<std::size_t>(high)};
  }

  void fill(Vec3 place, double radius) {
    if (!is_in(place)) return;
    const auto xs = range(place.x, radius, grid_.count[0]);
    const auto ys = range(place.y, radius, grid_.count[1]);
    const auto zs = range(place.z, radius, grid_.count[2]);
    for (std::size_t x = xs[0]; x <= xs[1]; ++x)
      for (std::size_t y = ys[0]; y <= ys[1]; ++y)
        for (std::size_t z = zs[0]; z <= zs[1]; ++z) {
          const Vec3 at{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          if (norm_squared(at - place) <= radius * radius) filled_[grid_.at(x, y, z)] = 1;
        }
  }

  Vec3 low_;
  Grid grid_;
  Mask filled_;
};

}  // namespace

std::size_t count_enclosed(std::span<const Vec3> points, std::span<const Vec3> positions,
                           std::span<const double> radii) {
  if (points.empty()) return 0;
  const FilledCells cells(points, positions, radii);
  static const Rays rays = spread_rays();
  return static_cast<std::size_t>(
      std::ranges::count_if(points, [&](Vec3 point) { return cells.is_enclosed(point, rays); }));
}

}  // namespace pliant
