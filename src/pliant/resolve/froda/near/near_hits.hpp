// SPDX-License-Identifier: MIT
// Which of many points are near one: the innermost loop of a list of near pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pliant {

/// Points [from, to) of arrays.
struct NearRun {
  std::uint32_t from, to;
};

/// Points to look at, (n) floats each (Angstrom). The arrays hold `points_beyond` more, which are
/// read but never reported.
struct NearPoints {
  const float *x, *y, *z;
};

/// More entries than there are points may be read, and more than are found may be written to.
inline constexpr std::size_t points_beyond = 8, hits_beyond = 8;

/// Writes to `squares` (n and `points_beyond`) the squared distance of each point of `runs` to
/// point `k`, and to `hits` the numbers of those below `widest`, as the runs have them; how many.
/// `hits` has room for all of the runs and `hits_beyond`.
using FindNearHits = std::size_t (*)(NearPoints points, std::span<const NearRun> runs,
                                     std::uint32_t k, float widest, float* squares,
                                     std::uint32_t* hits);

/// Those that this processor can do, which give the same bits; the last is the fastest.
std::span<const FindNearHits> near_hits_finders();

}  // namespace pliant
