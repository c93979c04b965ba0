// SPDX-License-Identifier: MIT
// The convex hull of points in space, by the planes of its faces.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Points p with dot(normal, p) + offset <= 0 are on the inner side.
struct Plane {
  Vec3 normal;  ///< of unit length, outwards
  double offset = 0.0;

  double height(Vec3 p) const { return dot(normal, p) + offset; }
};

/// The planes of the hull of `points` (n), finite; none if these lie in one plane.
/// Point by point: the faces that one sees give way to those between it and their outline. O(n^2).
std::vector<Plane> convex_hull(std::span<const Vec3> points);

}  // namespace pliant
