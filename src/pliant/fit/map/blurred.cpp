// SPDX-License-Identifier: MIT
#include "pliant/fit/map/blurred.hpp"

#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

/// Half of a Gaussian of sum 1 at whole steps: the middle, and what is on either side of it.
std::vector<float> half_kernel(double sigma_in_steps, std::size_t longest) {
  const double reach = std::floor(5.0 * sigma_in_steps + 0.5);
  std::vector<double> half;
  double sum = 0.0;
  for (double k = 0.0; k <= reach; ++k) {
    half.push_back(exact_bits_exp(-0.5 * (k / sigma_in_steps) * (k / sigma_in_steps)));
    sum += k == 0.0 ? half.back() : 2.0 * half.back();
  }
  if (half.size() > longest) half.resize(longest);
  for (double& value : half) value /= sum;
  return {half.begin(), half.end()};
}

/// out[k] += factor * in[k], for `count` values.
void add_times(float factor, const float* in, float* out, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) out[k] += factor * in[k];
}

/// Convolves a block of `count` slices of `width` values each, along the slices. Slice by slice
/// where these are wide, so that what is written stays near; else all slices of a shift at once.
void blur_block(const std::vector<float>& half, const float* in, float* out, std::size_t count,
                std::size_t width) {
  const std::size_t run = width >= 16 ? 1 : count;
  for (std::size_t first = 0; first < count; first += run) {
    add_times(half[0], in + first * width, out + first * width, run * width);
    for (std::size_t shift = 1; shift < half.size(); ++shift) {
      const std::size_t skipped = shift > first ? shift - first : 0;
      if (skipped < run)
        add_times(half[shift], in + (first + skipped - shift) * width,
                  out + (first + skipped) * width, (run - skipped) * width);
      const std::size_t left = count - first;
      if (shift < left)
        add_times(half[shift], in + (first + shift) * width, out + first * width,
                  std::min(run, left - shift) * width);
    }
  }
}

std::vector<float> blurred_along(const Grid& points, std::span<const float> values,
                                 std::size_t axis, double sigma_in_steps) {
  const std::size_t count = points.count[axis], width = points.stride(axis);
  const std::vector<float> half = half_kernel(sigma_in_steps, count);
  std::vector<float> out(values.size(), 0.0F);
  for (std::size_t start = 0; start < values.size(); start += count * width)
    blur_block(half, values.data() + start, out.data() + start, count, width);
  return out;
}

MapGrid right_angled_around(const MapGrid& grid) {
  std::vector<Vec3> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const auto end = [&](std::size_t axis) {
      return (k >> axis & 1) != 0 ? static_cast<double>(grid.count[axis] - 1) : 0.0;
    };
    corners.push_back(grid.place(end(0), end(1), end(2)));
  }
  const Extent box = extent_of(corners);
  const double volume = std::abs(dot(grid.steps[0], cross(grid.steps[1], grid.steps[2])));
  const double spacing = exact_bits_exp(exact_bits_log(volume) / 3.0);
  const Vec3 size = box.high - box.low;
  MapGrid out;
  out.origin = box.low;
  out.steps = {Vec3{spacing, 0, 0}, Vec3{0, spacing, 0}, Vec3{0, 0, spacing}};
  const auto count = [&](double length) {
    return static_cast<std::size_t>(std::ceil(length / spacing)) + 1;
  };
  out.count = {count(size.x), count(size.y), count(size.z)};
  check(out);
  return out;
}

DensityMap with_greatest_one(const DensityMap& map) {
  const double greatest = map.statistics().greatest;
  if (!(greatest > 0.0)) throw InputError("density map: no value is above 0");
  return scaled(map, 0.0, greatest);
}

}  // namespace

DensityMap on_right_angles(const DensityMap& map) {
  if (map.grid().is_right_angled()) return map;
  const MapGrid grid = right_angled_around(map.grid());
  std::vector<float> values;
  values.reserve(grid.size());
  for (std::size_t point = 0; point < grid.size(); ++point)
    values.push_back(static_cast<float>(map.at(place_of(grid, point)).value));
  return {grid, std::move(values)};
}

DensityMap blurred_by(const DensityMap& map, double sigma) {
  if (!map.grid().is_right_angled()) return blurred_by(on_right_angles(map), sigma);
  const std::array<double, 3> spacing = map.grid().spacing();
  std::vector<float> values(map.values().begin(), map.values().end());
  for (std::size_t axis = 0; axis < 3; ++axis)
    values = blurred_along(map.grid().points(), values, axis, sigma / spacing[axis]);
  return {map.grid(), std::move(values)};
}

DensityMap blurred(const DensityMap& map, double resolution) {
  check_resolution(resolution);
  return blurred_by(map, sigma_per_resolution * resolution);
}

std::vector<DensityMap> density_pyramid(const DensityMap& map, double resolution,
                                        std::size_t levels) {
  check_resolution(resolution);
  std::vector<DensityMap> pyramid;
  for (std::size_t level = levels; level-- > 1;) {
    const auto times = static_cast<double>(std::size_t{1} << level);
    const double sigma = sigma_per_resolution * resolution * std::sqrt(times * times - 1.0);
    pyramid.push_back(with_greatest_one(blurred_by(map, sigma)));
  }
  pyramid.push_back(with_greatest_one(map));
  return pyramid;
}

}  // namespace pliant
