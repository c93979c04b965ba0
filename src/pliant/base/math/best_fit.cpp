// SPDX-License-Identifier: MIT
#include "pliant/base/math/best_fit.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace pliant {
namespace {

/// Makes a[p][q] vanish (Golub, Van Loan, Matrix Computations, 8.5).
template <class Size>
void rotate_pair(std::span<double> a, std::span<double> vectors, Size n, std::size_t p,
                 std::size_t q) {
  const double off = a[p * n + q];
  if (off == 0.0) return;
  const double tau = (a[q * n + q] - a[p * n + p]) / (2.0 * off);
  const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
  const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
  for (std::size_t k = 0; k < n; ++k) {
    const double kp = a[k * n + p], kq = a[k * n + q];
    a[k * n + p] = c * kp - s * kq;
    a[k * n + q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double pk = a[p * n + k], qk = a[q * n + k];
    a[p * n + k] = c * pk - s * qk;
    a[q * n + k] = s * pk + c * qk;
    const double vp = vectors[k * n + p], vq = vectors[k * n + q];
    vectors[k * n + p] = c * vp - s * vq;
    vectors[k * n + q] = s * vp + c * vq;
  }
  a[p * n + q] = a[q * n + p] = 0.0;  // but for rounding, which would keep the sweeps going
}

template <class Size>
double largest_off_diagonal(std::span<const double> a, Size n) {
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) largest = std::max(largest, std::abs(a[i * n + j]));
  return largest;
}

/// `Size` is a number, or a constant that the compiler unrolls the loops for.
template <class Size>
void sweep_pairs(std::span<double> a, std::span<double> vectors, Size n) {
  constexpr int most_sweeps = 60;
  std::fill(vectors.begin(), vectors.end(), 0.0);
  for (std::size_t k = 0; k < n; ++k) vectors[k * n + k] = 1.0;
  double size = 0.0;
  for (double entry : a) size = std::max(size, std::abs(entry));
  for (int sweep = 0; sweep < most_sweeps && largest_off_diagonal(a, n) > 1e-20 * size; ++sweep)
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) rotate_pair(a, vectors, n, p, q);
}

/// The rotation of a unit quaternion (w, x, y, z).
Rotation rotation_of(double w, double x, double y, double z) {
  return {{w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
          {2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)},
          {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z}};
}

}  // namespace

Rotation turn_about(Vec3 axis, double t) {
  const double w = 1.0 / std::sqrt(1.0 + t * t);
  return rotation_of(w, w * t * axis.x, w * t * axis.y, w * t * axis.z);
}

Rotation product(const Rotation& a, const Rotation& b) {
  const auto row = [&](Vec3 r) { return r.x * b.x + r.y * b.y + r.z * b.z; };
  return {row(a.x), row(a.y), row(a.z)};
}

void find_eigenvectors(std::span<double> a, std::span<double> vectors, std::size_t n) {
  sweep_pairs(a, vectors, n);
}

RotationFit::Fit RotationFit::solve(bool mirror_allowed, Rotation& out) const {
  const Vec3 x = x_, y = y_, z = z_;
  std::array<double, 16> n{x.x + y.y + z.z, y.z - z.y,       z.x - x.z,        x.y - y.x,
                           y.z - z.y,       x.x - y.y - z.z, x.y + y.x,        z.x + x.z,
                           z.x - x.z,       x.y + y.x,       -x.x + y.y - z.z, y.z + z.y,
                           x.y - y.x,       z.x + x.z,       y.z + z.y,        -x.x - y.y + z.z};
  double size = 0.0;
  for (double entry : n) size += std::abs(entry);
  if (!std::isfinite(size)) return Fit::not_finite;
  if (size == 0.0) return Fit::undefined;
  for (double& entry : n) entry /= size;
  std::array<double, 16> vectors;
  sweep_pairs(std::span<double>(n), std::span<double>(vectors),
              std::integral_constant<std::size_t, 4>());
  std::size_t most = 0, least = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (n[5 * k] > n[5 * most]) most = k;
    if (n[5 * k] < n[5 * least]) least = k;
  }
  const bool mirrored = mirror_allowed && -n[5 * least] > n[5 * most];
  const std::size_t k = mirrored ? least : most;
  const double w = vectors[k], i = vectors[4 + k], j = vectors[8 + k], l = vectors[12 + k];
  const double norm = std::sqrt(w * w + i * i + j * j + l * l);
  out = rotation_of(w / norm, i / norm, j / norm, l / norm);
  return mirrored ? Fit::mirrored : Fit::fitted;
}

}  // namespace pliant
