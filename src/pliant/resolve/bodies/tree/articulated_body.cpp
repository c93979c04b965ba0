// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/articulated_body.hpp"

namespace pliant {
namespace {

/// A turn that moves less than this, against what the inertia could give, moves nothing.
constexpr double vanishing = 1e-12;
constexpr double least_inertia = 1e-6;  // in joints, at a unit of length

std::size_t entry(std::size_t i, std::size_t j) {
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

void factorize(Inertia& m, double square_unit) {
  for (std::size_t j = 0; j < 6; ++j) {
    double& pivot = m[entry(j, j)];
    pivot += j < 3 ? least_inertia * square_unit : least_inertia;
    for (std::size_t k = 0; k < j; ++k) pivot -= m[entry(j, k)] * m[entry(j, k)] * m[entry(k, k)];
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = m[entry(i, j)];
      for (std::size_t k = 0; k < j; ++k) sum -= m[entry(i, k)] * m[entry(j, k)] * m[entry(k, k)];
      m[entry(i, j)] = sum / pivot;
    }
  }
}

}  // namespace

void add_point(Inertia& a, Twist& force, Vec3 x, Vec3 pull, double w) {
  const Vec3 wx = w * x;
  const double square = dot(wx, x);
  a[0] += square - wx.x * x.x;
  a[1] -= wx.y * x.x, a[2] += square - wx.y * x.y;
  a[3] -= wx.z * x.x, a[4] -= wx.z * x.y, a[5] += square - wx.z * x.z;
  a[7] += wx.z, a[8] -= wx.y, a[9] += w;
  a[10] -= wx.z, a[12] += wx.x, a[14] += w;
  a[15] += wx.y, a[16] -= wx.x, a[20] += w;
  const Vec3 f = w * pull, moment = cross(x, f);
  const Twist add = twist_of(moment, f);
  for (std::size_t k = 0; k < 6; ++k) force[k] += add[k];
}

Twist solve_free(Inertia a, Twist b) {
  for (std::size_t j = 0; j < 6; ++j) {
    const double diagonal = a[entry(j, j)];
    for (std::size_t k = 0; k < j; ++k)
      a[entry(j, j)] -= a[entry(j, k)] * a[entry(j, k)] * a[entry(k, k)];
    const double pivot = a[entry(j, j)];
    const bool vanishes = !(pivot > vanishing * diagonal);
    if (vanishes) a[entry(j, j)] = HUGE_VAL;
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = a[entry(i, j)];
      for (std::size_t k = 0; k < j; ++k) {
        const double share = a[entry(i, k)] * a[entry(j, k)];
        if (share != 0.0) sum -= share * a[entry(k, k)];
      }
      a[entry(i, j)] = vanishes ? 0.0 : sum / pivot;
    }
  }
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[entry(i, k)] * b[k];
  for (std::size_t i = 0; i < 6; ++i) b[i] /= a[entry(i, i)];
  for (std::size_t i = 6; i-- > 0;)
    for (std::size_t k = i + 1; k < 6; ++k) b[i] -= a[entry(k, i)] * b[k];
  return b;
}

/// X^T I X where X carries a twist to the offset: (w, v) -> (w, v + w x r).
void add_body(Inertia& inertia, Twist& force, const Inertia& other, const Twist& other_force,
              Vec3 offset) {
  std::array<Vec3, 6> half;  // rows of I X, their first three entries
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec3 turn{other[entry(i, 0)], other[entry(i, 1)], other[entry(i, 2)]};
    const Vec3 shift{other[entry(i, 3)], other[entry(i, 4)], other[entry(i, 5)]};
    half[i] = turn + cross(offset, shift);
  }
  const Vec3 r = offset;
  const std::array<Vec3, 3> turns{half[0] + r.y * half[5] - r.z * half[4],
                                  half[1] + r.z * half[3] - r.x * half[5],
                                  half[2] + r.x * half[4] - r.y * half[3]};
  inertia[0] += turns[0].x;
  inertia[1] += turns[1].x, inertia[2] += turns[1].y;
  inertia[3] += turns[2].x, inertia[4] += turns[2].y, inertia[5] += turns[2].z;
  for (std::size_t i = 3; i < 6; ++i) {
    const std::array<double, 3> row{half[i].x, half[i].y, half[i].z};
    for (std::size_t j = 0; j < 3; ++j) inertia[entry(i, j)] += row[j];
    for (std::size_t j = 3; j <= i; ++j) inertia[entry(i, j)] += other[entry(i, j)];
  }
  const Vec3 pull = lower_of(other_force), moment = upper_of(other_force) + cross(offset, pull);
  const Twist moved = twist_of(moment, pull);
  for (std::size_t i = 0; i < 6; ++i) force[i] += moved[i];
}

void BodyTurn::eliminate(Inertia& inertia, Twist& force) {
  u = froda::product(inertia, s);
  d = froda::dot(s, u);
  angle = froda::dot(s, force);
  double most = 0.0;
  for (std::size_t i = 0; i < 6; ++i) most += s[i] * s[i] * inertia[entry(i, i)];
  if (!(d > vanishing * most)) d = 0.0;
  if (d == 0.0) return;
  froda::add_scaled(-angle / d, u, force);
  froda::add_direction(-1.0 / d, u, inertia);
}

void BodyTurn::settle(Twist& twist) {
  angle = d > 0.0 ? (angle - froda::dot(u, twist)) / d : 0.0;
  froda::add_scaled(angle, s, twist);
}

Twist froda::solve6(Inertia m, Twist v, double square_unit) {
  factorize(m, square_unit);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k) v[i] -= m[entry(i, k)] * v[k];
  for (std::size_t i = 0; i < 6; ++i) v[i] /= m[entry(i, i)];
  for (std::size_t i = 6; i-- > 0;)
    for (std::size_t k = i + 1; k < 6; ++k) v[i] -= m[entry(k, i)] * v[k];
  return v;
}

}  // namespace pliant
