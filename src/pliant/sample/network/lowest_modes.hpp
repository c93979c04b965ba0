// SPDX-License-Identifier: MIT
// The lowest eigenvalues above zero, and their eigenvectors, of a large symmetric matrix with a
// known null space.
#pragma once

#include <cstddef>
#include <vector>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/base/math/symmetric_eigen.hpp"

namespace pliant {

/// The `count` lowest eigenpairs of `a` (n x n, symmetric, positive semidefinite) above 1e-9 of the
/// largest diagonal entry. `still` (z x n, orthonormal rows) are known directions of the null
/// space. Returns fewer if there are fewer.
///
/// Up to 300 rows symmetric_eigen() is used. Above, the Krylov space of the inverse grows by blocks
/// (block Lanczos; Grimes, Lewis, Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228), until the
/// residuals are below 1e-9 of the eigenvalues: n^3 / 3 operations for the factors and some hundred
/// products of 2 n^2. A block has eight vectors, so that up to eight equal eigenvalues are found.
EigenPairs lowest_modes(DenseMatrix a, const DenseMatrix& still, std::size_t count);

}  // namespace pliant
