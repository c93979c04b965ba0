// SPDX-License-Identifier: MIT
// Which of many points are near one: the innermost loop of a list of near pairs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pliant {

/// Points [from, to) of arrays.
struct NearRun {
  std::uint32_t from, to;
};

/// Points to look at, (n) floats each (Angstrom).
struct NearPoints {
  const float *x, *y, *z;
};

/// More entries of `hits` than are found may be written to.
inline constexpr std::size_t hits_beyond = 4;

/// Writes to `squares` (n) the squared distance of each point of `run` to point `k`, and to `hits`
/// the numbers of those below `widest`; how many. `hits` has room for the run and `hits_beyond`.
std::size_t find_near_hits(const NearPoints& points, NearRun run, std::uint32_t k, float widest,
                           float* squares, std::uint32_t* hits);

}  // namespace pliant
