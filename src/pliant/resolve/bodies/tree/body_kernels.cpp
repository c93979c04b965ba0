// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/body_kernels.hpp"

namespace pliant::froda {
namespace {

constexpr double least_inertia = 1e-6;  // in joints, at a unit of length

std::size_t entry(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

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

Twist solve6(Inertia m, Twist v, double square_unit) {
  factorize(m, square_unit);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k) v[i] -= m[entry(i, k)] * v[k];
  for (std::size_t i = 0; i < 6; ++i) v[i] /= m[entry(i, i)];
  for (std::size_t i = 6; i-- > 0;)
    for (std::size_t k = i + 1; k < 6; ++k) v[i] -= m[entry(k, i)] * v[k];
  return v;
}

}  // namespace pliant::froda
