// SPDX-License-Identifier: MIT
#include "pliant/base/math/dense_solve.hpp"

#include <cmath>
#include <cstddef>

namespace pliant {
namespace {

/// Rows that are reduced side by side, so that none waits for the sum of another.
constexpr std::size_t together = 8;

/// Takes off entry (i, j) what the columns before j leave of it, for rows i.
template <std::size_t rows>
void reduce(double* const a, std::size_t n, std::size_t i, std::size_t j, double inverse) {
  double sums[rows];
  for (std::size_t r = 0; r < rows; ++r) sums[r] = a[(i + r) * n + j];
  const double* const pivot_row = a + j * n;
  for (std::size_t k = 0; k < j; ++k)
    for (std::size_t r = 0; r < rows; ++r) sums[r] -= a[(i + r) * n + k] * pivot_row[k];
  for (std::size_t r = 0; r < rows; ++r) a[(i + r) * n + j] = sums[r] * inverse;
}

}  // namespace

bool solve_positive(std::vector<double>& a, std::vector<double>& b, double least_pivot) {
  const std::size_t n = b.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double diagonal = a[j * n + j];
    reduce<1>(a.data(), n, j, j, 1.0);
    if (!(a[j * n + j] > least_pivot * diagonal)) return false;
    const double inverse = 1.0 / std::sqrt(a[j * n + j]);
    a[j * n + j] *= inverse;
    std::size_t i = j + 1;
    for (; i + together <= n; i += together) reduce<together>(a.data(), n, i, j, inverse);
    for (; i < n; ++i) reduce<1>(a.data(), n, i, j, inverse);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i * n + k] * b[k];
    b[i] /= a[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k * n + i] * b[k];
    b[i] /= a[i * n + i];
  }
  return true;
}

}  // namespace pliant
