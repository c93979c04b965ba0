// SPDX-License-Identifier: MIT
#include "pliant/base/math/dense_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

/// Rows that are finished together, so that the rest is read and written once for all of them.
constexpr std::size_t panel = 4;
/// Rows whose panels are taken off the rest tile by tile, of so many columns, which stay in caches.
constexpr std::size_t block = 32, tile = 256;
constexpr double least_pivot = 1e-14;

}  // namespace

DenseCholesky::DenseCholesky(DenseMatrix a) : u_(std::move(a)) {
  const std::size_t n = u_.rows();
  double largest = 0.0;
  for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, u_(k, k));
  for (std::size_t k = 0; k < n; k += block) {
    const std::size_t last = std::min(k + block, n);
    finish_block(k, last, least_pivot * largest);
    update_below(k, last);
  }
}

void DenseCholesky::finish_block(std::size_t first, std::size_t last, double least) {
  for (std::size_t k = first; k < last; k += panel) {
    const std::size_t end = std::min(k + panel, last);
    finish_rows(k, end, least);
    for (std::size_t i = end; i < last; ++i) update_row(i, k, i, u_.columns());
  }
}

void DenseCholesky::finish_rows(std::size_t first, std::size_t last, double least) {
  for (std::size_t k = first; k < last; ++k) {
    for (std::size_t above = first; above < k; ++above)
      add_scaled(-u_(above, k), u_.row(above).subspan(k), u_.row(k).subspan(k));
    const double scale = 1.0 / std::sqrt(std::max(u_(k, k), least));
    for (double& value : u_.row(k).subspan(k)) value *= scale;
    u_(k, k) = 1.0 / scale;
  }
}

/// Takes four finished rows off columns [from, to) of row i.
void DenseCholesky::update_row(std::size_t i, std::size_t first, std::size_t from, std::size_t to) {
  const double *p = u_.row(first).data(), *q = u_.row(first + 1).data(),
               *r = u_.row(first + 2).data(), *s = u_.row(first + 3).data();
  double* row = u_.row(i).data();
  const double a = p[i], b = q[i], c = r[i], d = s[i];
  for (std::size_t j = from; j < to; ++j) row[j] -= (a * p[j] + b * q[j]) + (c * r[j] + d * s[j]);
}

/// Takes the rows of a whole block off all below.
void DenseCholesky::update_below(std::size_t first, std::size_t last) {
  const std::size_t n = u_.rows();
  for (std::size_t left = last; left < n; left += tile) {
    const std::size_t right = std::min(left + tile, n);
    for (std::size_t i = last; i < right; ++i)
      for (std::size_t k = first; k < last; k += panel) update_row(i, k, std::max(i, left), right);
  }
}

void DenseCholesky::solve(EightVectors& b) const {
  solve_forward(b, 0);
  solve_backward(b);
}

/// A^-1 = U^-1 U^-T: entry k of its diagonal is the square of the solution of U^T x = e_k, which
/// has nothing above row k.
std::vector<double> DenseCholesky::inverse_diagonal() const {
  const std::size_t n = u_.rows();
  std::vector<double> diagonal(n, 0.0);
  EightVectors b(n);
  for (std::size_t first = 0; first < n; first += 8) {
    for (std::size_t j = first; j < n; ++j) b[j].fill(0.0);
    for (std::size_t k = first; k < std::min(first + 8, n); ++k) b[k][k - first] = 1.0;
    solve_forward(b, first);
    std::array<double, 8> sums{};
    for (std::size_t j = first; j < n; ++j)
      for (std::size_t lane = 0; lane < 8; ++lane) sums[lane] += b[j][lane] * b[j][lane];
    for (std::size_t k = first; k < std::min(first + 8, n); ++k) diagonal[k] = sums[k - first];
  }
  return diagonal;
}

/// Four rows at a time: first among themselves, then off all below. Rows above `begin`, a multiple
/// of four, are zero.
void DenseCholesky::solve_forward(EightVectors& b, std::size_t begin) const {
  const std::size_t n = u_.rows();
  const auto take_off = [&](std::size_t k, std::size_t from, std::size_t to) {
    for (std::size_t j = from; j < to; ++j)
      for (std::size_t lane = 0; lane < 8; ++lane) b[j][lane] -= u_(k, j) * b[k][lane];
  };
  for (std::size_t first = begin; first < n; first += panel) {
    const std::size_t last = std::min(first + panel, n);
    for (std::size_t k = first; k < last; ++k) {
      const double inverse = 1.0 / u_(k, k);
      for (double& value : b[k]) value *= inverse;
      take_off(k, k + 1, last);
    }
    if (last < first + panel) return;
    const auto p = b[first], q = b[first + 1], r = b[first + 2], s = b[first + 3];
    const double *up = u_.row(first).data(), *uq = u_.row(first + 1).data(),
                 *ur = u_.row(first + 2).data(), *us = u_.row(first + 3).data();
    for (std::size_t j = last; j < n; ++j)
      for (std::size_t lane = 0; lane < 8; ++lane)
        b[j][lane] -= (up[j] * p[lane] + uq[j] * q[lane]) + (ur[j] * r[lane] + us[j] * s[lane]);
  }
}

/// Four rows at a time: first what lies below them, then they among themselves.
void DenseCholesky::solve_backward(EightVectors& b) const {
  const std::size_t n = u_.rows();
  for (std::size_t last = n; last > 0;) {
    const std::size_t first = (last - 1) / panel * panel;
    std::array<std::array<double, 8>, panel> sums{};
    for (std::size_t k = first; k < last; ++k) {
      std::array<double, 8> sum{};
      const double* row = u_.row(k).data();
      for (std::size_t j = last; j < n; ++j)
        for (std::size_t lane = 0; lane < 8; ++lane) sum[lane] += row[j] * b[j][lane];
      sums[k - first] = sum;
    }
    for (std::size_t k = last; k-- > first;) {
      auto& sum = sums[k - first];
      for (std::size_t j = k + 1; j < last; ++j)
        for (std::size_t lane = 0; lane < 8; ++lane) sum[lane] += u_(k, j) * b[j][lane];
      const double inverse = 1.0 / u_(k, k);
      for (std::size_t lane = 0; lane < 8; ++lane) b[k][lane] = (b[k][lane] - sum[lane]) * inverse;
    }
    last = first;
  }
}

}  // namespace pliant
