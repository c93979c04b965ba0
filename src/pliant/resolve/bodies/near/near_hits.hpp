// SPDX-License-Identifier: MIT
// Finds points near a given one: the innermost loop of a list of near pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pliant {

/// Points [from, to) of arrays.
struct NearRun {
  std::uint32_t from, to;
};

/// Points to be searched, (n) floats each (Angstrom). The arrays have `points_beyond` more entries,
/// which are read but never reported.
struct NearPoints {
  const float *x, *y, *z;
};

/// Entries beyond the points that may be read, and beyond the hits that may be written.
inline constexpr std::size_t points_beyond = 8, hits_beyond = 8;

/// Writes to `squares` (n and `points_beyond`) the squared distance of each point of `runs` to
/// point `k`, and to `hits` the indices of those below `widest`, in the order of the runs. Returns
/// how many. `hits` has room for all points of the runs and `hits_beyond` more.
using FindNearHits = std::size_t (*)(NearPoints points, std::span<const NearRun> runs,
                                     std::uint32_t k, float widest, float* squares,
                                     std::uint32_t* hits);

/// The variants that this processor can run, which give the same bits; the last is the fastest.
std::span<const FindNearHits> near_hits_finders();

}  // namespace pliant
