// SPDX-License-Identifier: MIT
#include "pliant/measure/convex_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace pliant {
namespace {

/// A point this much above a plane, as a share of the extent of all, is still in it.
constexpr double hull_tolerance = 1e-10;

struct Face {
  std::array<Vec3, 3> corners;  ///< counter-clockwise as seen from outside
  Plane plane;
};

using Edge = std::pair<Vec3, Vec3>;

Face face_of(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 across = cross(b - a, c - a);
  const Vec3 normal = (1.0 / norm(across)) * across;
  return {{a, b, c}, {normal, -dot(normal, a)}};
}

/// The point for which a measure is largest.
template <class Measure>
Vec3 point_of_most(std::span<const Vec3> points, const Measure& measure) {
  return *std::ranges::max_element(points, {}, measure);
}

class Hull {
 public:
  explicit Hull(std::span<const Vec3> points) {
    const Vec3 a = point_of_most(points, [](Vec3 p) { return -p.x; });
    const Vec3 b = point_of_most(points, [&](Vec3 p) { return norm_squared(p - a); });
    const Vec3 c = point_of_most(points, [&](Vec3 p) { return norm_squared(cross(p - a, b - a)); });
    least_ = hull_tolerance * distance(a, b);
    if (!(norm(cross(c - a, b - a)) > least_ * distance(a, b))) return;
    const Plane plane = face_of(a, b, c).plane;
    const Vec3 d = point_of_most(points, [&](Vec3 p) { return std::abs(plane.height(p)); });
    if (!(std::abs(plane.height(d)) > least_)) return;
    begin(a, b, c, d, plane.height(d) < 0.0);
    for (const Vec3 p : points) add(p);
  }

  std::vector<Plane> planes() const {
    std::vector<Plane> found;
    for (const Face& face : faces_) found.push_back(face.plane);
    return found;
  }

 private:
  /// Four points; `below`: whether the last is below the plane of the others.
  void begin(Vec3 a, Vec3 b, Vec3 c, Vec3 d, bool below) {
    if (!below) std::swap(a, b);
    faces_ = {face_of(a, b, c), face_of(b, a, d), face_of(c, b, d), face_of(a, c, d)};
  }

  void add(Vec3 point) {
    const auto is_seen = [&](const Face& face) { return face.plane.height(point) > least_; };
    const auto seen = std::ranges::partition(faces_, std::not_fn(is_seen));
    if (seen.empty()) return;
    const std::vector<Edge> outline = outline_of(seen);
    faces_.erase(seen.begin(), faces_.end());
    for (const auto& [a, b] : outline) faces_.push_back(face_of(a, b, point));
  }

  /// The edges of faces that belong to one of them only.
  template <class Faces>
  static std::vector<Edge> outline_of(const Faces& faces) {
    std::vector<Edge> edges, outline;
    for (const Face& face : faces)
      for (std::size_t k = 0; k < 3; ++k)
        edges.emplace_back(face.corners[k], face.corners[(k + 1) % 3]);
    for (const auto& [a, b] : edges)
      if (std::ranges::find(edges, Edge{b, a}) == edges.end()) outline.emplace_back(a, b);
    return outline;
  }

  double least_ = 0.0;
  std::vector<Face> faces_;
};

}  // namespace

std::vector<Plane> convex_hull(std::span<const Vec3> points) {
  return points.empty() ? std::vector<Plane>{} : Hull(points).planes();
}

}  // namespace pliant
