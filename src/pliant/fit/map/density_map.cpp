// SPDX-License-Identifier: MIT
#include "pliant/fit/map/density_map.hpp"

#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

/// The cell that a place on a grid is in along one axis, and how far it is within that cell.
struct Within {
  std::size_t cell;
  double part;
};

constexpr const char* outside_text =
    "density map: the molecule lies outside of it; put it there first (place)";

/// A place that rounding has put this far outside is inside.
constexpr double slack = 1e-9;

bool is_inside(double place, std::size_t count) {
  // NaN is not inside.
  return place >= -slack && place <= static_cast<double>(count - 1) + slack;
}

Within within(double place, std::size_t count) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const auto cell = std::min(static_cast<std::size_t>(inside), count - 2);
  return {cell, inside - static_cast<double>(cell)};
}

/// A value between two, and how it changes from the one to the other.
struct Line {
  double value, slope;
};

Line between(double low, double high, double part) {
  return {low + part * (high - low), high - low};
}

}  // namespace

void check_resolution(double resolution) {
  if (!(resolution >= 0.5 && resolution <= 200.0))
    throw OptionError("resolution = " + number_text(resolution) +
                      ": must be from 0.5 to 200 (Angstrom)");
}

std::string not_finite_text(const Grid& points, std::span<const float> values) {
  const auto is_bad = [](float one) { return !std::isfinite(one); };
  const auto count = std::count_if(values.begin(), values.end(), is_bad);
  if (count == 0) return {};
  const auto first =
      static_cast<std::size_t>(std::find_if(values.begin(), values.end(), is_bad) - values.begin());
  const std::size_t row = first / points.count[2];
  return std::to_string(count) + " that are not, the first at point " +
         std::to_string(row / points.count[1]) + ", " + std::to_string(row % points.count[1]) +
         ", " + std::to_string(first % points.count[2]);
}

DensityMap::DensityMap(const MapGrid& grid, std::vector<float> values)
    : grid_(grid), places_((check(grid), grid)), values_(std::move(values)) {
  if (values_.size() != grid_.size())
    throw InputError("density map: expected " + std::to_string(grid_.size()) + " values, found " +
                     std::to_string(values_.size()));
  if (const std::string fault = not_finite_text(grid_.points(), values_); !fault.empty())
    throw InputError("density map: expected finite values, found " + fault);
}

DensityAt DensityMap::at(Vec3 place) const {
  const Vec3 on_grid = places_(place);
  const bool is_inside_box = is_inside(on_grid.x, grid_.count[0]) &&
                             is_inside(on_grid.y, grid_.count[1]) &&
                             is_inside(on_grid.z, grid_.count[2]);
  if (!is_inside_box) return {};
  const Within x = within(on_grid.x, grid_.count[0]), y = within(on_grid.y, grid_.count[1]),
               z = within(on_grid.z, grid_.count[2]);
  const Grid points = grid_.points();
  const float* corner = values_.data() + points.at(x.cell, y.cell, z.cell);
  const std::size_t dx = points.stride(0), dy = points.stride(1);
  const Line z00 = between(corner[0], corner[1], z.part);
  const Line z01 = between(corner[dy], corner[dy + 1], z.part);
  const Line z10 = between(corner[dx], corner[dx + 1], z.part);
  const Line z11 = between(corner[dx + dy], corner[dx + dy + 1], z.part);
  const Line y0 = between(z00.value, z01.value, y.part);
  const Line y1 = between(z10.value, z11.value, y.part);
  const Line all = between(y0.value, y1.value, x.part);
  const double along_y = between(y0.slope, y1.slope, x.part).value;
  const double along_z = between(between(z00.slope, z01.slope, y.part).value,
                                 between(z10.slope, z11.slope, y.part).value, x.part)
                             .value;
  const std::array<Vec3, 3>& rows = places_.rows();
  return {all.value, all.slope * rows[0] + along_y * rows[1] + along_z * rows[2], true};
}

DensitiesAt DensityMap::at(std::span<const Vec3> places) const {
  DensitiesAt out;
  out.values.reserve(places.size());
  out.gradients.reserve(places.size());
  for (const Vec3 place : places) {
    const DensityAt found = at(place);
    out.values.push_back(found.value);
    out.gradients.push_back(found.gradient);
    out.outside += !found.is_inside;
  }
  return out;
}

MapStatistics DensityMap::statistics() const {
  MapStatistics out;
  const auto [least, greatest] = std::minmax_element(values_.begin(), values_.end());
  out.least = *least;
  out.greatest = *greatest;
  for (const float value : values_) out.mean += value;
  const auto count = static_cast<double>(values_.size());
  out.mean /= count;
  double squares = 0.0;
  for (const float value : values_) squares += (value - out.mean) * (value - out.mean);
  out.deviation = std::sqrt(squares / count);
  return out;
}

DensityMap scaled(const DensityMap& map, double shift, double unit) {
  std::vector<float> values(map.values().begin(), map.values().end());
  for (float& value : values) value = static_cast<float>((value - shift) / unit);
  return {map.grid(), std::move(values)};
}

DensityMap cropped(const DensityMap& map, std::span<const Vec3> positions, double margin) {
  const MapGrid& grid = map.grid();
  GridBox box{grid.count, {}};
  for (const Vec3 position : positions) {
    const GridBox one = box_around(grid, map.places(), position, margin);
    for (std::size_t k = 0; k < 3; ++k) {
      if (one.low[k] >= one.high[k]) continue;
      box.low[k] = std::min(box.low[k], one.low[k]);
      box.high[k] = std::max(box.high[k], one.high[k]);
    }
  }
  MapGrid part = grid;
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.high[k] < box.low[k] + 2) throw InputError(outside_text);
    part.count[k] = box.high[k] - box.low[k];
  }
  part.origin = grid.place(static_cast<double>(box.low[0]), static_cast<double>(box.low[1]),
                           static_cast<double>(box.low[2]));
  std::vector<float> values;
  values.reserve(part.size());
  for (std::size_t i = box.low[0]; i < box.high[0]; ++i)
    for (std::size_t j = box.low[1]; j < box.high[1]; ++j) {
      const std::size_t first = grid.points().at(i, j, box.low[2]);
      const auto row = map.values().subspan(first, part.count[2]);
      values.insert(values.end(), row.begin(), row.end());
    }
  return {part, std::move(values)};
}

double median(const DensityMap& map) {
  std::vector<float> sorted(map.values().begin(), map.values().end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

DensityMap normalized(const DensityMap& map) {
  const MapStatistics found = map.statistics();
  if (!(found.greatest > found.least))
    throw InputError("density map: all values are " + number_text(found.least));
  return scaled(map, found.mean, found.deviation);
}

}  // namespace pliant
