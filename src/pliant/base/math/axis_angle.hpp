// SPDX-License-Identifier: MIT
// Rotations by axis and angle. Sines and cosines whose bits depend on no C library.
#pragma once

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

struct AxisAngle {
  Vec3 axis{0, 0, 1};  ///< unit length
  double angle = 0.0;  ///< radians, 0 to pi
};

/// The rotation about a unit axis by an angle (radians).
Rotation rotation_by(Vec3 axis, double angle);

/// The axis and the angle of a rotation. An axis of 180 degrees may point either way.
AxisAngle axis_angle(const Rotation& rotation);

Rotation inverse(const Rotation& rotation);

}  // namespace pliant
