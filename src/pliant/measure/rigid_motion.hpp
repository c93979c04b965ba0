// SPDX-License-Identifier: MIT
// How much of the motion of sites is rigid, when they are taken as two bodies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Moves of n sites along m motions, from their mean places, kept by reference.
struct SiteMoves {
  std::span<const Vec3> mean;     ///< (n) Angstrom
  std::span<const double> moves;  ///< (n x 3 x m) Angstrom
  std::size_t motions() const { return moves.size() / (3 * mean.size()); }
};

/// Sites `first` to before `end` change sides.
struct Stretch {
  std::int64_t first, end;
};

/// The sums of squares of the moves that two bodies follow as rigid ones (least squares, to first
/// order), for each stretch: the one is the sites with `is_one` (n, 0 or 1), the other all others,
/// once the sites of the stretch have changed sides. A body of no sites follows nothing.
std::vector<std::array<double, 2>> followed_rigidly(const SiteMoves& sites,
                                                    std::span<const std::uint8_t> is_one,
                                                    std::span<const Stretch> stretches);

}  // namespace pliant
