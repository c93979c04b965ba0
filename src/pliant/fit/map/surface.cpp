// SPDX-License-Identifier: MIT
#include "pliant/fit/map/surface.hpp"

#include <functional>
#include <limits>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

using Index = std::array<std::size_t, 3>;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The corners of a cell by the bits of their numbers: bit `axis` is one step along it.
constexpr std::size_t corners = 8;

double volume_of_cell(const MapGrid& grid) {
  return dot(grid.steps[0], cross(grid.steps[1], grid.steps[2]));
}

/// The map with a layer of points around it that have nothing: point (i, j, k) of the map is here
/// (i + 1, j + 1, k + 1). A cell has the number of its lowest corner.
class Padded {
 public:
  Padded(const DensityMap& map, double level) : map_(map), level_(level) {}

  bool is_inside(Index at) const { return value(at) >= level_; }
  /// Cells along each axis.
  Grid cells() const {
    const Index& count = map_.grid().count;
    return {{count[0] + 1, count[1] + 1, count[2] + 1}};
  }
  /// Where the surface crosses between a point inside and one outside.
  Vec3 crossing(Index inside, Index outside) const {
    const double high = value(inside), share = (high - level_) / (high - value(outside));
    return place(inside) + share * (place(outside) - place(inside));
  }

 private:
  double value(Index at) const {
    const Grid points = map_.grid().points();
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] == 0 || at[k] > points.count[k]) return -std::numeric_limits<double>::infinity();
    return map_.values()[points.at(at[0] - 1, at[1] - 1, at[2] - 1)];
  }
  Vec3 place(Index at) const {
    const auto along = [&](std::size_t k) { return static_cast<double>(at[k]) - 1.0; };
    return map_.grid().place(along(0), along(1), along(2));
  }

  const DensityMap& map_;
  double level_;
};

Index corner_of(Index cell, std::size_t corner) {
  return {cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1)};
}

template <class Visit>
void for_each_cell(const Grid& cells, const Visit& visit) {
  for (std::size_t i = 0; i < cells.count[0]; ++i)
    for (std::size_t j = 0; j < cells.count[1]; ++j)
      for (std::size_t k = 0; k < cells.count[2]; ++k) visit(Index{i, j, k});
}

/// The numbers of the vertices by cell, `none` where the surface does not cross it; they are put
/// into `vertices`.
std::vector<std::uint32_t> vertices_of_cells(const Padded& padded, std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> numbers(padded.cells().size(), none);
  std::size_t number = 0;
  for_each_cell(padded.cells(), [&](Index cell) {
    Vec3 sum;
    double count = 0.0;
    for (std::size_t one = 0; one < corners; ++one)
      for (const std::size_t step : {1U, 2U, 4U}) {
        if ((one & step) != 0) continue;
        const Index from = corner_of(cell, one), to = corner_of(cell, one | step);
        const bool is_first = padded.is_inside(from);
        if (is_first == padded.is_inside(to)) continue;
        sum += is_first ? padded.crossing(from, to) : padded.crossing(to, from);
        ++count;
      }
    if (count > 0.0) {
      numbers[number] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back((1.0 / count) * sum);
    }
    ++number;
  });
  return numbers;
}

/// Two triangles between the vertices of the four cells about an edge, cut by the shorter diagonal.
void add_quad(Surface& surface, std::array<std::uint32_t, 4> q, bool is_turned) {
  const auto across = [&](std::size_t a, std::size_t b) {
    return norm_squared(surface.vertices[q[a]] - surface.vertices[q[b]]);
  };
  if (across(1, 3) < across(0, 2)) q = {q[1], q[2], q[3], q[0]};
  if (is_turned) std::swap(q[1], q[3]);
  surface.triangles.push_back({q[0], q[1], q[2]});
  surface.triangles.push_back({q[0], q[2], q[3]});
}

/// The quad of each edge, along `axis`, from inside to outside or back.
void add_quads_along(Surface& surface, const Padded& padded,
                     const std::vector<std::uint32_t>& numbers, std::size_t axis,
                     bool is_mirrored) {
  const Grid cells = padded.cells();
  const std::size_t next = cells.stride((axis + 1) % 3), last = cells.stride((axis + 2) % 3);
  for_each_cell(cells, [&](Index from) {
    Index to = from;
    ++to[axis];
    const bool is_out = padded.is_inside(from);
    if (is_out == padded.is_inside(to)) return;
    const std::size_t cell = cells.at(from[0], from[1], from[2]);
    const auto of = [&](std::size_t back) { return numbers[cell - back]; };
    add_quad(surface, {of(next + last), of(last), of(0), of(next)}, is_out == is_mirrored);
  });
}

}  // namespace

Surface surface_of(const DensityMap& map, double level) {
  const double greatest = map.statistics().greatest;
  if (!(std::isfinite(level) && level <= greatest))
    throw OptionError("level = " + number_text(level) +
                      ": must be at most the greatest value of the map, " + number_text(greatest));
  const Padded padded(map, level);
  Surface surface;
  const std::vector<std::uint32_t> numbers = vertices_of_cells(padded, surface.vertices);
  const bool is_mirrored = volume_of_cell(map.grid()) < 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    add_quads_along(surface, padded, numbers, axis, is_mirrored);
  return surface;
}

double level_around(const DensityMap& map, double volume) {
  const double cell = std::abs(volume_of_cell(map.grid()));
  const double whole = cell * static_cast<double>(map.grid().size());
  if (!(volume > 0.0 && volume <= whole))
    throw OptionError("volume = " + number_text(volume) +
                      ": must be above 0 and at most that of the map, " + number_text(whole));
  std::vector<float> sorted(map.values().begin(), map.values().end());
  const auto count = std::max(1.0, std::floor(volume / cell));
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(sorted.begin(), last, sorted.end(), std::greater<>());
  return *last;
}

}  // namespace pliant
