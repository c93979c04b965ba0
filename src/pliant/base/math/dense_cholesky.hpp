// SPDX-License-Identifier: MIT
// Cholesky's factors of a dense symmetric matrix, and solving with them for eight vectors at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pliant/base/math/dense_matrix.hpp"

namespace pliant {

/// Eight vectors: entry k holds the k-th number of each.
using EightVectors = std::vector<std::array<double, 8>>;

/// A = U^T U. Sums go in one fixed order.
class DenseCholesky {
 public:
  /// Factorizes `a` (n x n), of which only the upper triangle is read. A pivot that is not above
  /// 1e-14 of the largest diagonal entry is set to that.
  explicit DenseCholesky(DenseMatrix a);

  /// Solves A x = b in place.
  void solve(EightVectors& b) const;

  /// (n) the diagonal of the inverse; takes n^3 / 3 operations.
  std::vector<double> inverse_diagonal() const;

 private:
  void finish_rows(std::size_t first, std::size_t last, double least);
  void finish_block(std::size_t first, std::size_t last, double least);
  void update_row(std::size_t i, std::size_t first, std::size_t from, std::size_t to);
  void update_below(std::size_t first, std::size_t last);
  void solve_forward(EightVectors& b, std::size_t begin) const;
  void solve_backward(EightVectors& b) const;

  DenseMatrix u_;
};

}  // namespace pliant
