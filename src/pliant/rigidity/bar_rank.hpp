// SPDX-License-Identifier: MIT
// Rank of the rigidity matrix of a framework, at its positions and at almost all others, and which
// bars are redundant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A singular value up to this counts as 0. The row of a bar has its unit vector at one end, minus
/// it at the other.
inline constexpr double rank_tolerance = 1e-9;
/// A bar takes part in self-stresses if its share is above this; all of a bar's stress is 1.
inline constexpr double stress_tolerance = 1e-6;
/// Up to so many bars and coordinates together, singular values decide. Above, sparse QR does.
inline constexpr std::size_t most_for_singular_values = 300;

/// The rank, and the bars (B) without any one of which it stays what it is.
struct BarRank {
  std::size_t rank = 0;
  std::vector<bool> redundant;
  /// (B) what each bar adds to the number of independent self-stresses, bars - rank: a part of the
  /// framework that no bar of a self-stress leaves has as many as its bars add up to.
  std::vector<double> stresses;
};

/// BarRank at given positions.
struct BarRankThere : BarRank {
  bool has_singular_values = false;
  /// Singular values above 0 that are below 1e-4, ascending; with QR, lengths of rows.
  std::vector<double> nearly_dependent;
  double least = 0.0;    ///< the least that counts in the rank; 0: none
  double dropped = 0.0;  ///< the largest that does not; 0: none
};

/// Rank of the matrix with a row for each bar: its direction at the coordinates of its one end,
/// minus that at those of the other. `dimension` 2 takes x and y; pinned joints have no
/// coordinates. Singular values for small frameworks; else sparse QR by rotations of rows (George,
/// Heath, Linear Algebra Appl. 34 (1980) 69), its columns in the order of minimum degree: linear
/// where few loops close, with the fill-in of a sparse Cholesky factor elsewhere. The same bits on
/// every machine.
BarRankThere bar_rank(const Framework& framework, std::span<const Vec3> positions,
                      std::uint32_t dimension);

/// The same at almost all positions: exact arithmetic modulo 2^61 - 1 at random positions, which is
/// wrong with a probability below the number of bars over 10^18.
BarRank generic_bar_rank(const Framework& framework, std::uint32_t dimension);

}  // namespace pliant
