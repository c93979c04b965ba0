// SPDX-License-Identifier: MIT
#include "pliant/resolve/units/dense_solve.hpp"

#include <cmath>

namespace pliant {

bool solve_positive(std::vector<double>& a, std::vector<double>& b, double least_pivot) {
  const std::size_t n = b.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double diagonal = a[j * n + j];
    for (std::size_t k = 0; k < j; ++k)
      for (std::size_t i = j; i < n; ++i) a[i * n + j] -= a[i * n + k] * a[j * n + k];
    if (!(a[j * n + j] > least_pivot * diagonal)) return false;
    const double inverse = 1.0 / std::sqrt(a[j * n + j]);
    for (std::size_t i = j; i < n; ++i) a[i * n + j] *= inverse;
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
