// SPDX-License-Identifier: MIT
// Solves a small dense system with sums in one fixed order: the same bits from every compiler,
// unlike a library that uses wide instructions where available.
#pragma once

#include <vector>

namespace pliant {

/// Solves A x = b in place by Cholesky's L L^T; A (n x n, its lower triangle) is overwritten.
/// Returns false if a pivot is not above `least_pivot` times its diagonal entry.
bool solve_positive(std::vector<double>& a, std::vector<double>& b, double least_pivot);

}  // namespace pliant
