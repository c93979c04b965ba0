// SPDX-License-Identifier: MIT
// Domains: sets of nodes that keep their distances to each other in the lowest modes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// A tree of clusters by average linkage (UPGMA; Sokal, Michener, Univ. Kansas Sci. Bull. 38 (1958)
/// 1409), found along chains of nearest neighbours in O(n^2) (Murtagh, Comput. J. 26 (1983) 354).
class AverageLinkage {
 public:
  /// Takes `distances` (n x n, symmetric, not negative).
  explicit AverageLinkage(DenseMatrix distances);

  /// The cluster of each of the n items when there are `count` clusters, numbered in the order of
  /// their first members.
  std::vector<std::uint32_t> cut(std::size_t count) const;

 private:
  struct Merge {
    std::uint32_t one, other;  ///< members of the two clusters
    double height;
  };

  std::size_t things_;
  std::vector<Merge> merges_;  ///< sorted by height
};

/// The r.m.s. change of the distance of each two nodes in a Gaussian of modes (rows of 3n numbers)
/// with these variances: s_ij^2 = sum_m variance_m (n_ij . (u_mi - u_mj))^2.
DenseMatrix changes_of_distances(std::span<const Vec3> positions, const DenseMatrix& modes,
                                 std::span<const double> variances);

}  // namespace pliant
