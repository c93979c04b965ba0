// SPDX-License-Identifier: MIT
// Operations on twists and inertias in lanes, as in articulated_body.hpp of resolve/bodies; a part
// of lane_level.cpp.
#pragma once

#include "pliant/resolve/lanes/lane_bodies.hpp"
#include "pliant/resolve/lanes/lane_memory_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

constexpr double least_inertia = 1e-6;  // as in articulated_body.cpp

PLIANT_LANE_INLINE const Lanes* numbers(const LaneValue* x) {
  return reinterpret_cast<const Lanes*>(x);
}
PLIANT_LANE_INLINE LaneValue value_of(const Lanes& x) {
  LaneValue value;
  __builtin_memcpy(&value, &x, sizeof value);
  return value;
}
PLIANT_LANE_INLINE Lanes lanes_of(const LaneValue& x) { return *numbers(&x); }

PLIANT_LANE_INLINE LaneVec3 cross(const LaneVec3& a, const LaneVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PLIANT_LANE_INLINE Lanes sixfold(const Lanes* a, const Lanes* b) {
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}
PLIANT_LANE_INLINE void add_scaled6(const Lanes& factor, const Lanes* x, Lanes* y) {
  for (int k = 0; k < 6; ++k) y[k] += factor * x[k];
}
PLIANT_LANE_INLINE LaneVec3 upper(const Lanes* twist) { return {twist[0], twist[1], twist[2]}; }
PLIANT_LANE_INLINE LaneVec3 lower(const Lanes* twist) { return {twist[3], twist[4], twist[5]}; }
PLIANT_LANE_INLINE LaneVec3 velocity(const Lanes* twist, const LaneVec3& x) {
  return lower(twist) + cross(upper(twist), x);
}
PLIANT_LANE_INLINE void set_twist(const LaneVec3& up, const LaneVec3& low, Lanes* twist) {
  twist[0] = up.x, twist[1] = up.y, twist[2] = up.z;
  twist[3] = low.x, twist[4] = low.y, twist[5] = low.z;
}

PLIANT_LANE_INLINE void multiply(const Lanes* m, const Lanes* s, Lanes* out) {
  out[0] =
      ((m[0] * s[0] + m[1] * s[1]) + (m[3] * s[2] + m[6] * s[3])) + (m[10] * s[4] + m[15] * s[5]);
  out[1] =
      ((m[1] * s[0] + m[2] * s[1]) + (m[4] * s[2] + m[7] * s[3])) + (m[11] * s[4] + m[16] * s[5]);
  out[2] =
      ((m[3] * s[0] + m[4] * s[1]) + (m[5] * s[2] + m[8] * s[3])) + (m[12] * s[4] + m[17] * s[5]);
  out[3] =
      ((m[6] * s[0] + m[7] * s[1]) + (m[8] * s[2] + m[9] * s[3])) + (m[13] * s[4] + m[18] * s[5]);
  out[4] = ((m[10] * s[0] + m[11] * s[1]) + (m[12] * s[2] + m[13] * s[3])) +
           (m[14] * s[4] + m[19] * s[5]);
  out[5] = ((m[15] * s[0] + m[16] * s[1]) + (m[17] * s[2] + m[18] * s[3])) +
           (m[19] * s[4] + m[20] * s[5]);
}

constexpr int entry_of(int i, int j) { return i * (i + 1) / 2 + j; }

/// L D L^T of a 6 x 6 matrix.
PLIANT_LANE_INLINE void solve_root(const Lanes* inertia, const Lanes* force, double square_unit,
                                   Lanes* v) {
  Lanes m[21];
  for (int k = 0; k < 21; ++k) m[k] = inertia[k];
  for (int j = 0; j < 6; ++j) {
    Lanes& pivot = m[entry_of(j, j)];
    pivot += j < 3 ? least_inertia * square_unit : least_inertia;
    for (int k = 0; k < j; ++k) pivot -= m[entry_of(j, k)] * m[entry_of(j, k)] * m[entry_of(k, k)];
    for (int i = j + 1; i < 6; ++i) {
      Lanes sum = m[entry_of(i, j)];
      for (int k = 0; k < j; ++k) sum -= m[entry_of(i, k)] * m[entry_of(j, k)] * m[entry_of(k, k)];
      m[entry_of(i, j)] = sum / pivot;
    }
  }
  for (int i = 0; i < 6; ++i) v[i] = force[i];
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < i; ++k) v[i] -= m[entry_of(i, k)] * v[k];
  for (int i = 0; i < 6; ++i) v[i] = v[i] / m[entry_of(i, i)];
  for (int i = 6; i-- > 0;)
    for (int k = i + 1; k < 6; ++k) v[i] -= m[entry_of(k, i)] * v[k];
}

void add_scaled(const LaneValue& factor, const LaneValue* x, std::size_t count, LaneValue* y) {
  const Lanes by = lanes_of(factor);
  for (std::size_t k = 0; k < count; ++k) *numbers(&y[k]) += by * lanes_of(x[k]);
}

void add_to_scaled(const LaneValue* x, const LaneValue& factor, std::size_t count, LaneValue* y) {
  const Lanes by = lanes_of(factor);
  for (std::size_t k = 0; k < count; ++k) *numbers(&y[k]) = lanes_of(x[k]) + by * lanes_of(y[k]);
}

void copy_lanes(LaneMask lanes, const LaneValue* x, std::size_t count, LaneValue* y) {
  const Mask mask = Mask::of(lanes);
  for (std::size_t k = 0; k < count; ++k)
    *numbers(&y[k]) = select(mask, lanes_of(x[k]), lanes_of(y[k]));
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
