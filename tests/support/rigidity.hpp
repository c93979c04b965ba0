// SPDX-License-Identifier: MIT
// Facts of the rigidity matrix by brute force, with Eigen.
#pragma once

#include <cstddef>
#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant::test {

/// Rank of the rigidity matrix (rows of unit bar directions), by singular values above 1e-9.
std::size_t rigidity_rank(const Framework& framework, std::span<const Vec3> positions);
/// The least singular value of the rigidity matrix: 0 when bars depend on each other, 1 if there
/// are none.
double least_singular_value(const Framework& framework, std::span<const Vec3> positions);
/// Dimension of the span of translations and rotations of the joints.
std::size_t rigid_motions(std::span<const Vec3> positions);

}  // namespace pliant::test
