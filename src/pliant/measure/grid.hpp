// SPDX-License-Identifier: MIT
// Points of a grid in space, and what is known of each: which are of one region, and how far the
// nearest of some of them is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// The corners of the box around some points.
struct Extent {
  Vec3 low, high;
};
Extent extent_of(std::span<const Vec3> points);

/// Points x, y, z from 0 to below `count`, z running fastest.
struct Grid {
  std::array<std::size_t, 3> count{};

  std::size_t size() const { return count[0] * count[1] * count[2]; }
  std::size_t at(std::size_t x, std::size_t y, std::size_t z) const {
    return (x * count[1] + y) * count[2] + z;
  }
  /// From a point to the next along an axis.
  std::size_t stride(std::size_t axis) const {
    return axis == 2 ? 1 : axis == 1 ? count[2] : count[1] * count[2];
  }
};

/// A value of each point of a grid; truth values are bytes.
using Mask = std::vector<std::uint8_t>;

/// The nearest of some points.
struct NearestPoints {
  std::vector<std::int32_t> point;    ///< of each point of the grid; -1 if there are none
  std::vector<std::int32_t> squared;  ///< its distance, steps^2
};

/// The nearest point of `chosen` to each point, exactly, in linear time. Of equals along an axis
/// the lower is taken, z before y before x (C. Maurer, R. Qi, V. Raghavan, IEEE Trans. Pattern
/// Anal. Mach. Intell. 25 (2003) 265).
NearestPoints nearest_points(const Grid& grid, const Mask& chosen);

/// Regions of `chosen` whose points touch along an axis, numbered from 1 by their first points; 0
/// elsewhere.
std::vector<std::int32_t> regions_of(const Grid& grid, const Mask& chosen);

}  // namespace pliant
