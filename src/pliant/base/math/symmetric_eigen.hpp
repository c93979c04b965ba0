// SPDX-License-Identifier: MIT
// All eigenvalues and eigenvectors of a dense symmetric matrix: Householder's reflections to three
// diagonals, then implicit QL rotations (Golub, Van Loan, Matrix Computations, 8.3). Sums go in one
// fixed order, so that the bits depend neither on the processor nor on its caches, as those of
// libraries do that take matrices block by block.
#pragma once

#include <vector>

#include "pliant/base/math/dense_matrix.hpp"

namespace pliant {

struct EigenPairs {
  std::vector<double> values;  ///< (n) ascending
  DenseMatrix vectors;         ///< row k belongs to values[k]; unit length
};

/// Eigenvalues and eigenvectors of `a` (n x n, symmetric, finite), which is overwritten. About 5
/// n^3 operations.
EigenPairs symmetric_eigen(DenseMatrix a);

/// Chooses a vector's sign: the first of its entries of largest size (to within 1e-6) becomes
/// positive.
void make_sign_canonical(std::span<double> vector);

}  // namespace pliant
