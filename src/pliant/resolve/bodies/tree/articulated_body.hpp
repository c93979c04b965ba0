// SPDX-License-Identifier: MIT
// Twists, and inertias of rigid bodies connected by turns (articulated bodies, Featherstone, Int.
// J. Robot. Res. 2 (1983) 13). Consider the sum w |t - x|^2 over the joints of a body and of all
// that hangs on it with its best turns: the inertia is half its second derivative with respect to a
// twist of the body, and the force is minus half the first.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "pliant/base/math/best_fit.hpp"

namespace pliant {

/// (rotation, shift at the origin) of a motion, or (moment, force).
using Twist = std::array<double, 6>;
/// 6 x 6, symmetric: the lower triangle, by rows.
using Inertia = std::array<double, 21>;

inline Twist twist_of(Vec3 upper, Vec3 lower) {
  return {upper.x, upper.y, upper.z, lower.x, lower.y, lower.z};
}
inline Vec3 upper_of(const Twist& twist) { return {twist[0], twist[1], twist[2]}; }
inline Vec3 lower_of(const Twist& twist) { return {twist[3], twist[4], twist[5]}; }

/// The twist of a rotation about `axis` through a point.
inline Twist turn_of(Vec3 axis, Vec3 through) { return twist_of(axis, cross(through, axis)); }

inline double dot6(const Twist& a, const Twist& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k) sum += a[k] * b[k];
  return sum;
}

Twist times(const Inertia& inertia, const Twist& s);

/// Adds a point of weight w at x, pulled by w times `pull`.
void add_point(Inertia& inertia, Twist& force, Vec3 x, Vec3 pull, double w);

/// Adds inertia and force of a body relative to a point at `offset` from the point of `inertia` and
/// `force`.
void add_body(Inertia& inertia, Twist& force, const Inertia& other, const Twist& other_force,
              Vec3 offset);

/// Solves inertia v = force; there is no motion without inertia (a rod about itself).
Twist solve_free(Inertia inertia, Twist force);

/// One way in which a body turns relative to its parent.
struct BodyTurn {
  Twist s{}, u{};      ///< s begins with the axis; u = I s
  double d = 0.0;      ///< s . u; 0: nothing turns
  double angle = 0.0;  ///< before settle(): s . p
  Vec3 axis() const { return upper_of(s); }

  /// Eliminates this turn from the inertia and the force of the body.
  void eliminate(Inertia& inertia, Twist& force);
  /// Computes its angle (radians) from the motion of the parent, and adds it to `twist`.
  void settle(Twist& twist);
};

/// The rotation by a vector of axis times angle (radians), to second order in the angle.
inline Rotation turn_by(Vec3 vector) {
  const double angle = norm(vector);
  return angle > 0.0 ? turn_about((1.0 / angle) * vector, 0.5 * angle) : Rotation{};
}

}  // namespace pliant
