// SPDX-License-Identifier: MIT
#include "pliant/measure/grid.hpp"

#include <algorithm>

namespace pliant {
namespace {

/// The points of a line that are nearest to some of its points: the lower envelope of parabolas.
class LineOfPoints {
 public:
  explicit LineOfPoints(std::size_t most) : place_(most), squared_(most), point_(most) {}

  void clear() { count_ = 0; }

  /// A chosen point `squared` from the line, beside its point number `place`: higher than before.
  void add(std::int64_t place, std::int64_t squared, std::int32_t point) {
    while (count_ >= 2 && is_nowhere_nearest(place, squared)) --count_;
    place_[count_] = place;
    squared_[count_] = squared;
    point_[count_++] = point;
  }

  bool is_empty() const { return count_ == 0; }

  /// Writes the nearest of each of `length` points.
  void write(std::size_t length, std::size_t stride, std::int32_t* point,
             std::int32_t* squared) const {
    std::size_t k = 0;
    for (std::size_t i = 0; i < length; ++i) {
      std::int64_t apart = from(k, i);
      for (; k + 1 < count_; ++k) {
        const std::int64_t next = from(k + 1, i);
        if (apart <= next) break;
        apart = next;
      }
      point[i * stride] = point_[k];
      squared[i * stride] = static_cast<std::int32_t>(apart);
    }
  }

 private:
  /// Whether the last is further from every point of the line than the one before or the new one.
  bool is_nowhere_nearest(std::int64_t place, std::int64_t squared) const {
    const std::size_t last = count_ - 1;
    const std::int64_t before = place_[last] - place_[last - 1];
    const std::int64_t after = place - place_[last];
    const std::int64_t both = before + after;
    return both * squared_[last] - after * squared_[last - 1] - before * squared >
           before * after * both;
  }

  std::int64_t from(std::size_t k, std::size_t i) const {
    const std::int64_t along = place_[k] - static_cast<std::int64_t>(i);
    return along * along + squared_[k];
  }

  std::size_t count_ = 0;
  std::vector<std::int64_t> place_, squared_;
  std::vector<std::int32_t> point_;
};

/// From the nearest points in lines or planes to those along one axis more.
void add_axis(const Grid& grid, std::size_t axis, NearestPoints& nearest, LineOfPoints& line) {
  const std::size_t stride = grid.stride(axis), length = grid.count[axis];
  for (std::size_t block = 0; block < grid.size(); block += stride * length)
    for (std::size_t first = block; first < block + stride; ++first) {
      std::int32_t* point = &nearest.point[first];
      std::int32_t* squared = &nearest.squared[first];
      line.clear();
      for (std::size_t i = 0; i < length; ++i)
        if (point[i * stride] >= 0)
          line.add(static_cast<std::int64_t>(i), squared[i * stride], point[i * stride]);
      if (!line.is_empty()) line.write(length, stride, point, squared);
    }
}

/// The points of a grid beside one.
template <class Visit>
void for_neighbours(const Grid& grid, std::size_t point, const Visit& visit) {
  std::size_t rest = point;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const std::size_t stride = grid.stride(axis), place = rest / stride;
    rest %= stride;
    if (place > 0) visit(point - stride);
    if (place + 1 < grid.count[axis]) visit(point + stride);
  }
}

}  // namespace

Extent extent_of(std::span<const Vec3> points) {
  Extent all{points[0], points[0]};
  for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z})
    for (const Vec3& p : points) {
      all.low.*axis = std::min(all.low.*axis, p.*axis);
      all.high.*axis = std::max(all.high.*axis, p.*axis);
    }
  return all;
}

NearestPoints nearest_points(const Grid& grid, const Mask& chosen) {
  NearestPoints nearest;
  nearest.point.assign(grid.size(), -1);
  nearest.squared.assign(grid.size(), 0);
  for (std::size_t k = 0; k < grid.size(); ++k)
    if (chosen[k]) nearest.point[k] = static_cast<std::int32_t>(k);
  LineOfPoints line(std::max({grid.count[0], grid.count[1], grid.count[2]}));
  for (const std::size_t axis : {0U, 1U, 2U}) add_axis(grid, axis, nearest, line);
  return nearest;
}

std::vector<std::int32_t> regions_of(const Grid& grid, const Mask& chosen) {
  std::vector<std::int32_t> region(grid.size(), 0);
  std::vector<std::size_t> ahead;
  std::int32_t count = 0;
  for (std::size_t first = 0; first < grid.size(); ++first) {
    if (!chosen[first] || region[first] != 0) continue;
    region[first] = ++count;
    ahead.assign(1, first);
    while (!ahead.empty()) {
      const std::size_t point = ahead.back();
      ahead.pop_back();
      for_neighbours(grid, point, [&](std::size_t other) {
        if (!chosen[other] || region[other] != 0) return;
        region[other] = count;
        ahead.push_back(other);
      });
    }
  }
  return region;
}

}  // namespace pliant
