// SPDX-License-Identifier: MIT
// How plausible another shape of a molecule is, by what known pairs of structures of proteins have
// in common: how far apart they are, and that open ones close and closed ones open.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Chosen on both directions of 12 pairs of structures (../README.md).
class PlausibleShapes {
 public:
  /// The nodes of a molecule are at `start` (M, Angstrom); the time is the cube of their number.
  /// `scale` is that of NetworkNodes.
  explicit PlausibleShapes(std::span<const Vec3> start, double scale = 1.0);

  double softness() const { return softness_; }  ///< as softness() of network/softness.hpp
  /// Distance (RMSD of nodes, Angstrom) of the other structure that is expected of so soft a
  /// molecule.
  double expected() const { return expected_; }
  /// From -1, compact as closed proteins are, to 1, open.
  double openness() const { return openness_; }
  /// The natural logarithm of how plausible a shape (M) is, but for a constant.
  double score(std::span<const Vec3> shape) const;

 private:
  std::vector<Vec3> start_;
  double softness_, expected_, gyration_, openness_;
};

}  // namespace pliant
