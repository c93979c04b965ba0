// SPDX-License-Identifier: MIT
#include "pliant/sample/dense_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

/// Rows that are finished together, so that the rest is read and written once for all of them.
constexpr std::size_t panel = 4;
constexpr double least_pivot = 1e-14;

}  // namespace

DenseCholesky::DenseCholesky(DenseMatrix a) : u_(std::move(a)) {
  const std::size_t n = u_.rows();
  double largest = 0.0;
  for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, u_(k, k));
  for (std::size_t k = 0; k < n; k += panel) {
    const std::size_t last = std::min(k + panel, n);
    finish_rows(k, last, least_pivot * largest);
    if (last == k + panel) update_rows(k);
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

/// Takes four finished rows off those below.
void DenseCholesky::update_rows(std::size_t first) {
  const std::size_t n = u_.rows();
  const double *p = u_.row(first).data(), *q = u_.row(first + 1).data(),
               *r = u_.row(first + 2).data(), *s = u_.row(first + 3).data();
  for (std::size_t i = first + panel; i < n; ++i) {
    double* row = u_.row(i).data();
    const double a = p[i], b = q[i], c = r[i], d = s[i];
    for (std::size_t j = i; j < n; ++j) row[j] -= (a * p[j] + b * q[j]) + (c * r[j] + d * s[j]);
  }
}

void DenseCholesky::solve(EightVectors& b) const {
  const std::size_t n = u_.rows();
  for (std::size_t k = 0; k < n; ++k) {
    const auto row = u_.row(k);
    const double inverse = 1.0 / row[k];
    for (double& value : b[k]) value *= inverse;
    const std::array<double, 8> here = b[k];
    for (std::size_t j = k + 1; j < n; ++j)
      for (std::size_t lane = 0; lane < 8; ++lane) b[j][lane] -= row[j] * here[lane];
  }
  for (std::size_t k = n; k-- > 0;) {
    const auto row = u_.row(k);
    std::array<double, 8> sum = b[k];
    for (std::size_t j = k + 1; j < n; ++j)
      for (std::size_t lane = 0; lane < 8; ++lane) sum[lane] -= row[j] * b[j][lane];
    const double inverse = 1.0 / row[k];
    for (std::size_t lane = 0; lane < 8; ++lane) b[k][lane] = sum[lane] * inverse;
  }
}

}  // namespace pliant
