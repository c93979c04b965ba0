// SPDX-License-Identifier: MIT
#include "pliant/base/math/axis_angle.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {

Rotation rotation_by(Vec3 axis, double angle) {
  const double half = 0.5 * angle;
  return turn_about(axis, exact_bits_cos(half - 0.5 * std::numbers::pi) / exact_bits_cos(half));
}

namespace {

/// Of no turn or half a turn: in the latter each row of R + 1 lies along the axis.
AxisAngle without_sine(const Rotation& r) {
  if (r.x.x + r.y.y + r.z.z > 1.0) return {};
  const Vec3 rows[] = {r.x + Vec3{1, 0, 0}, r.y + Vec3{0, 1, 0}, r.z + Vec3{0, 0, 1}};
  const Vec3 longest = *std::max_element(std::begin(rows), std::end(rows), [](Vec3 a, Vec3 b) {
    return norm_squared(a) < norm_squared(b);
  });
  return {(1.0 / norm(longest)) * longest, std::numbers::pi};
}

}  // namespace

AxisAngle axis_angle(const Rotation& r) {
  const Vec3 twice_sine{r.z.y - r.y.z, r.x.z - r.z.x, r.y.x - r.x.y};
  const double length = norm(twice_sine);
  if (!(length > 1e-12)) return without_sine(r);
  return {(1.0 / length) * twice_sine, exact_bits_atan2(length, r.x.x + r.y.y + r.z.z - 1.0)};
}

Rotation inverse(const Rotation& r) {
  return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}

}  // namespace pliant
