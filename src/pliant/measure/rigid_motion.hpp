// SPDX-License-Identifier: MIT
// The rigid motion that sites follow best, frame by frame, and what it leaves of their motion.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Moves of n sites in F frames from their mean places, kept by reference.
struct SiteMoves {
  std::span<const Vec3> mean;      ///< (n) Angstrom
  std::span<const float> moves;    ///< (3n x F) x, y and z of the first site in all frames first
  std::span<const float> weights;  ///< (F) of the frames; they sum to 1
};

/// (n) mean square fluctuation of every site that is left when all follow the rigid motion that
/// fits the sites of `body` best (least squares, to first order).
std::vector<double> left_by_rigid_motion(const SiteMoves& sites,
                                         std::span<const std::int64_t> body);

}  // namespace pliant
