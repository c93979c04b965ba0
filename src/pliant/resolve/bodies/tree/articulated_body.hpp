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

namespace froda {

// Loops use plain pointers: without optimization they take a third of the time.

inline void add_scaled(double factor, const Twist& x, Twist& y) {
  const double* const from = x.data();
  double* const to = y.data();
  for (std::size_t k = 0; k < 6; ++k) to[k] += factor * from[k];
}

/// Scalar product, summed in pairs as in product().
inline double dot(const Twist& one, const Twist& other) {
  const double *const a = one.data(), *const b = other.data();
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}

/// Velocity of the point x under a twist.
inline Vec3 velocity(const Twist& twist, Vec3 x) {
  return lower_of(twist) + cross(upper_of(twist), x);
}

/// m s, summed in pairs, which takes half the time.
inline Twist product(const Inertia& inertia, const Twist& twist) {
  const double *const m = inertia.data(), *const s = twist.data();
  return {
      ((m[0] * s[0] + m[1] * s[1]) + (m[3] * s[2] + m[6] * s[3])) + (m[10] * s[4] + m[15] * s[5]),
      ((m[1] * s[0] + m[2] * s[1]) + (m[4] * s[2] + m[7] * s[3])) + (m[11] * s[4] + m[16] * s[5]),
      ((m[3] * s[0] + m[4] * s[1]) + (m[5] * s[2] + m[8] * s[3])) + (m[12] * s[4] + m[17] * s[5]),
      ((m[6] * s[0] + m[7] * s[1]) + (m[8] * s[2] + m[9] * s[3])) + (m[13] * s[4] + m[18] * s[5]),
      ((m[10] * s[0] + m[11] * s[1]) + (m[12] * s[2] + m[13] * s[3])) +
          (m[14] * s[4] + m[19] * s[5]),
      ((m[15] * s[0] + m[16] * s[1]) + (m[17] * s[2] + m[18] * s[3])) +
          (m[19] * s[4] + m[20] * s[5])};
}

/// m += weight g g^T.
inline void add_direction(double weight, const Twist& direction, Inertia& inertia) {
  const double* const g = direction.data();
  double* m = inertia.data();
  for (std::size_t i = 0; i < 6; ++i) {
    const double scaled = weight * g[i];
    for (std::size_t j = 0; j <= i; ++j) *m++ += scaled * g[j];
  }
}

/// Moments of points, from which the inertia of a body and the force on it are computed.
class PointSums {
 public:
  void add(Vec3 x) {
    ++count_;
    sum_ += x;
    xx_ += x.x * x.x;
    yy_ += x.y * x.y;
    zz_ += x.z * x.z;
    xy_ += x.x * x.y;
    xz_ += x.x * x.z;
    yz_ += x.y * x.z;
  }
  Inertia inertia() const {
    const Vec3 s = sum_;
    const double n = count_;
    return {yy_ + zz_, -xy_, xx_ + zz_, -xz_, -yz_, xx_ + yy_, 0.0,  s.z, -s.y, n,  //
            -s.z,      0.0,  s.x,       0.0,  n,    s.y,       -s.x, 0.0, 0.0,  0.0, n};
  }

 private:
  double count_ = 0.0, xx_ = 0.0, yy_ = 0.0, zz_ = 0.0, xy_ = 0.0, xz_ = 0.0, yz_ = 0.0;
  Vec3 sum_;
};

/// Solves m v = force by L D L^T. A small number is added to the diagonal, so that directions
/// without inertia (a rod about itself) do not move. `square_unit` is the square of the unit of
/// length (Angstrom^2).
Twist solve6(Inertia m, Twist force, double square_unit);

}  // namespace froda

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
