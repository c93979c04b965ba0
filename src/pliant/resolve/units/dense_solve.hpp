// SPDX-License-Identifier: MIT
// A small dense system, by sums in one fixed order: the same bits from every compiler, which a
// library that takes wide instructions where there are some does not give.
#pragma once

#include <vector>

namespace pliant {

/// Solves A x = b in place by Cholesky's L L^T; A (n x n, its lower triangle) is overwritten. False
/// if a pivot is not above `least_pivot` times its diagonal entry.
bool solve_positive(std::vector<double>& a, std::vector<double>& b, double least_pivot);

}  // namespace pliant
