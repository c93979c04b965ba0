// SPDX-License-Identifier: MIT
// Facts of the rigidity matrix by brute force, with Eigen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"

namespace pliant::test {

/// Rank of the rigidity matrix (rows of unit bar directions), by singular values above 1e-9.
std::size_t rigidity_rank(const Framework& framework, std::span<const Vec3> positions);
/// The least singular value of the rigidity matrix: 0 when bars depend on each other, 1 if there
/// are none.
double least_singular_value(const Framework& framework, std::span<const Vec3> positions);
/// Dimension of the span of translations and rotations of the joints.
std::size_t rigid_motions(std::span<const Vec3> positions);

/// Of bodies joined by bars.
struct BodyBarFacts {
  std::size_t rank = 0;
  /// (B) the lowest body that no motion moves against each: they are one rigid cluster.
  std::vector<std::uint32_t> cluster_of;
};

/// Every bar along a random line of its own: two bars are never parallel. Twists of bodies that
/// change no bar are the null space of the matrix.
BodyBarFacts body_bar_facts(std::size_t bodies, std::span<const BodyEdge> edges,
                            std::uint64_t seed);

/// Rank where bodies are atoms at these positions: five bars leave the turn about the line through
/// two atoms, six leave nothing. Throws std::invalid_argument for other numbers of bars.
std::size_t hinge_rank(std::span<const Vec3> positions, std::span<const BodyEdge> edges);

}  // namespace pliant::test
