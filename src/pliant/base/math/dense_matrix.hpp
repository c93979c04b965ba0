// SPDX-License-Identifier: MIT
// A dense matrix by rows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pliant {

/// rows x columns numbers, all 0 at first.
class DenseMatrix {
 public:
  DenseMatrix() = default;
  DenseMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), values_(rows * columns, 0.0) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  double& operator()(std::size_t i, std::size_t j) { return values_[i * columns_ + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values_[i * columns_ + j]; }
  std::span<double> row(std::size_t i) { return {values_.data() + i * columns_, columns_}; }
  std::span<const double> row(std::size_t i) const {
    return {values_.data() + i * columns_, columns_};
  }

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> values_;
};

/// y += factor x, number by number.
inline void add_scaled(double factor, std::span<const double> x, std::span<double> y) {
  for (std::size_t k = 0; k < x.size(); ++k) y[k] += factor * x[k];
}

/// Sum of x[k] y[k], by four sums side by side: the order is fixed, so the bits are.
inline double dot_product(std::span<const double> x, std::span<const double> y) {
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  std::size_t k = 0;
  for (; k + 4 <= x.size(); k += 4)
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += x[k + lane] * y[k + lane];
  for (std::size_t lane = 0; k < x.size(); ++k, ++lane) sums[lane] += x[k] * y[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace pliant
