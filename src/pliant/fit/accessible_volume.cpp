// SPDX-License-Identifier: MIT
#include "pliant/fit/accessible_volume.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/measure/free_radius.hpp"
#include "pliant/measure/grid.hpp"

namespace pliant {
namespace {

constexpr double step = 1.0;    // Angstrom
constexpr int margin = 2;       // steps: no hop leads out of the grid
constexpr int squares = 6;      // steps^2: longer hops gain little
constexpr double most = 100.0;  // Angstrom

/// From a point of the grid to another one.
struct Hop {
  int x, y, z;
  std::ptrdiff_t by;  ///< in the order of the grid
  float length;       ///< steps
};

/// The hops of at most so many steps^2.
std::vector<Hop> hops_within(const Grid& grid, double squared) {
  const int reach = int(std::sqrt(squared));
  std::vector<Hop> out;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach; ++z) {
        const int found = x * x + y * y + z * z;
        if (found == 0 || found > squared) continue;
        const auto by = x * std::ptrdiff_t(grid.stride(0)) + y * std::ptrdiff_t(grid.stride(1)) + z;
        out.push_back({x, y, z, by, std::sqrt(float(found))});
      }
  return out;
}

/// Shortest paths (E. Dijkstra, Numer. Math. 1 (1959) 269) over points of a grid that are free.
class Paths {
 public:
  Paths(const Grid& grid, const Mask& free)
      : free_(free), length(grid.size(), std::numeric_limits<float>::infinity()) {}

  void reach(std::size_t point, float at) {
    if (!free_[point] || at >= length[point]) return;
    length[point] = at;
    next_.emplace(at, point);
  }

  void follow(std::span<const Hop> hops, float longest) {
    while (!next_.empty()) {
      const auto [at, point] = next_.top();
      next_.pop();
      if (at > length[point]) continue;
      for (const Hop& hop : hops)
        if (at + hop.length <= longest)
          reach(std::size_t(std::ptrdiff_t(point) + hop.by), at + hop.length);
    }
  }

 private:
  using Reached = std::pair<float, std::size_t>;
  const Mask& free_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next_;

 public:
  std::vector<float> length;  ///< steps
};

/// All points within the length of the linker, in steps from the first corner.
struct Around {
  Around(Vec3 attached, const Dye& dye) : centre(int(std::ceil(dye.length / step)) + margin) {
    grid.count.fill(std::size_t(2 * centre + 1));
    origin = attached - double(centre) * step * Vec3{1, 1, 1};
  }
  std::vector<float> free_radii_among(std::span<const Vec3> atoms, std::span<const double> radii,
                                      double largest) const;

  int centre;
  Grid grid;
  Vec3 origin;
};

std::vector<float> Around::free_radii_among(std::span<const Vec3> atoms,
                                            std::span<const double> radii, double largest) const {
  std::vector<Vec3> places;
  std::vector<double> sizes;
  for (const Vec3 atom : atoms) places.push_back((1.0 / step) * (atom - origin));
  for (const double radius : radii) sizes.push_back(radius / step);
  return free_radii(grid, places, sizes, largest / step);
}

Mask at_least(std::span<const float> values, double least) {
  Mask found(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) found[k] = values[k] >= float(least);
  return found;
}

/// Of linkers to each point.
std::vector<float> path_lengths(const Around& around, const Mask& free, const Dye& dye) {
  const auto middle = std::size_t(around.centre);
  const std::size_t begin = around.grid.at(middle, middle, middle);
  const auto longest = float(dye.length / step);
  const double straight = std::min(dye.width / step + 1.0, dye.length / step);
  Paths paths(around.grid, free);
  paths.reach(begin, 0.0F);
  for (const Hop& hop : hops_within(around.grid, straight * straight))
    paths.reach(std::size_t(std::ptrdiff_t(begin) + hop.by), hop.length);
  paths.follow(hops_within(around.grid, squares), longest);
  return std::move(paths.length);
}

}  // namespace

void Dye::check() const {
  for (const double value : {length, width, radius})
    if (!(value > 0.0 && value <= most))
      throw OptionError("length, width, radius of a dye: must be above 0, at most 100 Angstrom");
}

std::vector<Vec3> accessible_volume(std::span<const Vec3> atoms, std::span<const double> radii,
                                    Vec3 attached, const Dye& dye) {
  dye.check();
  if (radii.size() != atoms.size()) throw InputError("radii: expected one for each atom");
  const Around around(attached, dye);
  const std::vector<float> room =
      around.free_radii_among(atoms, radii, std::max(dye.width / 2.0, dye.radius));
  const Mask dye_fits = at_least(room, dye.radius / step);
  const std::vector<float> length =
      path_lengths(around, at_least(room, dye.width / 2.0 / step), dye);
  std::vector<Vec3> found;
  for (std::size_t x = 0, k = 0; x < around.grid.count[0]; ++x)
    for (std::size_t y = 0; y < around.grid.count[1]; ++y)
      for (std::size_t z = 0; z < around.grid.count[2]; ++z, ++k)
        if (dye_fits[k] && std::isfinite(length[k]))
          found.push_back(around.origin + step * Vec3{double(x), double(y), double(z)});
  return found;
}

}  // namespace pliant
