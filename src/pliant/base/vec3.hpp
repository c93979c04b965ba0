// SPDX-License-Identifier: MIT
// A point or vector in space: three doubles, no padding, so that an (N, 3) array is a Vec3[N].
#pragma once

#include <cmath>

#ifdef __FAST_MATH__
#error "compile without -ffast-math: it hides not-finite numbers and changes results"
#endif

namespace pliant {

/// A point (Angstrom) or a vector.
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  constexpr Vec3& operator+=(Vec3 o) { return x += o.x, y += o.y, z += o.z, *this; }
  constexpr Vec3& operator-=(Vec3 o) { return x -= o.x, y -= o.y, z -= o.z, *this; }
  constexpr Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return s * a; }
  friend constexpr bool operator==(Vec3 a, Vec3 b) = default;
};
static_assert(sizeof(Vec3) == 3 * sizeof(double));

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double norm_squared(Vec3 a) { return dot(a, a); }
inline double norm(Vec3 a) { return std::sqrt(norm_squared(a)); }
inline double distance(Vec3 a, Vec3 b) { return norm(b - a); }
/// Below this the squared length is too near underflow for a direction.
inline constexpr double least_squared_length = 1e-300;
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace pliant
