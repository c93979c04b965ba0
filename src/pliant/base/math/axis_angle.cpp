// SPDX-License-Identifier: MIT
#include "pliant/base/math/axis_angle.hpp"

#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {

Rotation rotation_by(Vec3 axis, double angle) {
  const double half = 0.5 * angle;
  return turn_about(axis, exact_bits_cos(half - 0.5 * std::numbers::pi) / exact_bits_cos(half));
}

AxisAngle axis_angle(const Rotation& r) {
  const Vec3 twice_sine{r.z.y - r.y.z, r.x.z - r.z.x, r.y.x - r.x.y};
  const double length = norm(twice_sine);
  if (!(length > 1e-12)) return {{0, 0, 1}, 0.0};
  return {(1.0 / length) * twice_sine, exact_bits_atan2(length, r.x.x + r.y.y + r.z.z - 1.0)};
}

Rotation inverse(const Rotation& r) {
  return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}

}  // namespace pliant
