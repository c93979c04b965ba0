// SPDX-License-Identifier: MIT
#include "pliant/measure/pockets.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "pliant/measure/free_radius.hpp"
#include "pliant/measure/grid.hpp"

namespace pliant {
namespace {

/// A grid around all atoms, with room for a large probe beside them.
struct Around {
  explicit Around(std::span<const Vec3> positions, double largest) {
    const auto [low, high] = extent_of(positions);
    const double margin = large_probe + largest + pocket_step;
    const Vec3 origin = low - Vec3{margin, margin, margin};
    const auto count = [&](double from, double to) {
      return static_cast<std::size_t>(std::ceil((to + margin - from) / pocket_step)) + 1;
    };
    grid.count = {count(origin.x, high.x), count(origin.y, high.y), count(origin.z, high.z)};
    for (const Vec3 p : positions) places.push_back(p - origin);
  }

  Grid grid;
  std::vector<Vec3> places;  ///< of the atoms, in steps of the grid
};

Mask at_least(std::span<const float> values, float least) {
  Mask found(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) found[k] = values[k] >= least;
  return found;
}

/// The points where the centre of a large probe may be that comes from outside.
Mask outside_of(const Grid& grid, std::span<const float> free) {
  const std::vector<std::int32_t> region =
      regions_of(grid, at_least(free, static_cast<float>(large_probe)));
  Mask found(grid.size());
  for (std::size_t k = 0; k < grid.size(); ++k) found[k] = region[k] == region[0];
  return found;
}

/// Room for a small probe that no large one comes near to.
Mask deep_room(const Grid& grid, const std::vector<float>& free) {
  std::vector<float> widened(free);
  for (float& radius : widened) radius += static_cast<float>(least_depth);
  const Mask shallow = covered(grid, outside_of(grid, free), widened, pocket_step);
  Mask room = covered(grid, at_least(free, static_cast<float>(small_probe)), free, pocket_step);
  for (std::size_t k = 0; k < room.size(); ++k) room[k] = room[k] && !shallow[k];
  return room;
}

/// The number of each region among those that are large enough, from 0 by size; else -1.
std::vector<std::int64_t> numbers_by_size(std::span<const std::int32_t> region) {
  std::vector<std::size_t> sizes(1, 0);
  for (const std::int32_t k : region) {
    if (static_cast<std::size_t>(k) >= sizes.size()) sizes.resize(k + 1, 0);
    ++sizes[k];
  }
  constexpr double volume = pocket_step * pocket_step * pocket_step;
  std::vector<std::size_t> large;
  for (std::size_t k = 1; k < sizes.size(); ++k)
    if (static_cast<double>(sizes[k]) * volume >= least_pocket) large.push_back(k);
  std::ranges::stable_sort(large, std::greater{}, [&](std::size_t k) { return sizes[k]; });
  std::vector<std::int64_t> number(sizes.size(), -1);
  for (std::size_t k = 0; k < large.size(); ++k) number[large[k]] = static_cast<std::int64_t>(k);
  return number;
}

/// Atoms by x, to find the nearest to a point.
class AtomsAlong {
 public:
  explicit AtomsAlong(std::span<const Vec3> places) : places_(places), order_(places.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {}, [&](std::size_t k) { return places[k].x; });
  }

  std::size_t nearest(Vec3 point) const {
    const auto x_of = [&](std::size_t k) { return places_[k].x; };
    const auto middle = std::ranges::lower_bound(order_, point.x, {}, x_of);
    Best best;
    for (auto at = middle; at != order_.end() && may_be_nearer(*at, point, best); ++at)
      take(*at, point, best);
    for (auto at = middle; at != order_.begin() && may_be_nearer(*(at - 1), point, best); --at)
      take(*(at - 1), point, best);
    return best.atom;
  }

 private:
  struct Best {
    double squared = std::numeric_limits<double>::infinity();
    std::size_t atom = 0;
  };

  bool may_be_nearer(std::size_t atom, Vec3 point, const Best& best) const {
    const double along = places_[atom].x - point.x;
    return along * along < best.squared;
  }

  void take(std::size_t atom, Vec3 point, Best& best) const {
    const double squared = norm_squared(places_[atom] - point);
    if (squared < best.squared) best = {squared, atom};
  }

  std::span<const Vec3> places_;
  std::vector<std::size_t> order_;
};

}  // namespace

PocketPoints find_pockets(std::span<const Vec3> positions, std::span<const double> radii) {
  const Around around(positions, *std::ranges::max_element(radii));
  const Grid& grid = around.grid;
  const std::vector<float> free = free_radii(grid, around.places, radii, large_probe + pocket_step);
  const std::vector<std::int32_t> region = regions_of(grid, deep_room(grid, free));
  const std::vector<std::int64_t> number = numbers_by_size(region);
  const AtomsAlong atoms(around.places);
  PocketPoints found;
  std::size_t point = 0;
  for (std::size_t x = 0; x < grid.count[0]; ++x)
    for (std::size_t y = 0; y < grid.count[1]; ++y)
      for (std::size_t z = 0; z < grid.count[2]; ++z, ++point) {
        if (number[region[point]] < 0) continue;
        const Vec3 place{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        found.pocket.push_back(number[region[point]]);
        found.atom.push_back(static_cast<std::int64_t>(atoms.nearest(place)));
      }
  return found;
}

}  // namespace pliant
