// SPDX-License-Identifier: MIT
// Best fits of a rigid shape to points (superposition, least squares), by any rotation or by a turn
// about an axis. Both are in closed form but for the eigenvectors of a 4 x 4 matrix, and without
// trigonometry, whose last bits differ between C libraries. Neither reflects unless the caller
// allows it; then the result says whether the mirror image fits better.
#pragma once

#include <cmath>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// A proper rotation, by rows.
struct Rotation {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3 operator()(Vec3 p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
};

/// The turn about a unit axis by the angle whose half has the tangent t (Cayley): 2 t to second
/// order.
Rotation turn_about(Vec3 axis, double t);

/// The rotation that applies b first, then a.
Rotation product(const Rotation& a, const Rotation& b);

/// x -> rotation(x) + shift.
struct RigidMotion {
  Rotation rotation;
  Vec3 shift;
  Vec3 operator()(Vec3 p) const { return rotation(p) + shift; }
  /// The motion that first turns about the point `through`, then moves as this one does.
  RigidMotion after(const Rotation& turn, Vec3 through) const {
    return {product(rotation, turn), (*this)(through - turn(through))};
  }
};

/// Eigenvalues and eigenvectors of a symmetric matrix by Jacobi's rotations. `a` (n x n) is left
/// with the eigenvalues on its diagonal, `vectors` (n x n) with the eigenvectors as columns.
void find_eigenvectors(std::span<double> a, std::span<double> vectors, std::size_t n);

/// Gathers pairs of points, then gives the rotation R that makes sum w |target - R shape|^2 least:
/// the eigenvector of Horn's matrix (J. Opt. Soc. Am. A 4 (1987) 629).
class RotationFit {
 public:
  void add(Vec3 shape, Vec3 target, double weight) {
    const Vec3 s = weight * shape;
    x_ += s.x * target;
    y_ += s.y * target;
    z_ += s.z * target;
  }

  /// fitted: `out` is the best rotation. mirrored: the best rotation of the mirror image (all signs
  /// changed), which was allowed and fits better. undefined: shape or targets are at the origin.
  enum class Fit { fitted, mirrored, undefined, not_finite };
  Fit solve(bool mirror_allowed, Rotation& out) const;

 private:
  Vec3 x_, y_, z_;  ///< rows: sum of w shape_x target, ...
};

/// Two directions at right angles to a unit vector and each other (Duff et al., J. Comput. Graph.
/// Tech. 6 (2017) 1).
struct AxisBasis {
  Vec3 axis, e1, e2;
  explicit AxisBasis(Vec3 unit) : axis(unit) {
    const double sign = std::copysign(1.0, unit.z);
    const double a = -1.0 / (sign + unit.z), b = unit.x * unit.y * a;
    e1 = {1.0 + sign * unit.x * unit.x * a, sign * b, -sign * unit.x};
    e2 = {b, sign + unit.y * unit.y * a, -unit.y};
  }
};

/// The turn by angle t about an axis that makes sum w |target - turned shape|^2 least:
/// tan t = sum w (u t2 - v t1) / sum w (u t1 + v t2), shape (u, v) and target (t1, t2) at right
/// angles to the axis.
class TorsionFit {
 public:
  void add(double u, double v, double t1, double t2, double weight) {
    ut1_ += weight * u * t1;
    ut2_ += weight * u * t2;
    vt1_ += weight * v * t1;
    vt2_ += weight * v * t2;
  }

  struct Turn {
    double cosine = 1.0, sine = 0.0;
    double v_sign = 1.0;    ///< -1 for the mirror image (v changes its sign)
    double strength = 0.0;  ///< the sum that is greatest at this turn; 0: any turn fits as well
  };
  Turn solve(bool mirror_allowed) const {
    const Turn plain = turn(ut1_ + vt2_, ut2_ - vt1_, 1.0);
    if (!mirror_allowed) return plain;
    const Turn mirrored = turn(ut1_ - vt2_, ut2_ + vt1_, -1.0);
    return mirrored.strength > plain.strength ? mirrored : plain;
  }

 private:
  static Turn turn(double cosine, double sine, double v_sign) {
    const double strength = std::sqrt(cosine * cosine + sine * sine);
    return {cosine / strength, sine / strength, v_sign, strength};
  }

  double ut1_ = 0.0, ut2_ = 0.0, vt1_ = 0.0, vt2_ = 0.0;
};

}  // namespace pliant
