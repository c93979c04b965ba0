// SPDX-License-Identifier: MIT
// What is done to eight walkers at once (SIMD lanes), compiled for several levels of instructions
// of which the best that this processor knows is taken at run time. All levels give the same bits.
//
// Positions of walkers in lanes are LaneVectors: x of all eight, then y, then z. A kernel does what
// is common; where a walker needs more (coincident joints, a block that Newton's method does not
// make whole at once) it says so, and that walker is resolved alone from its start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "pliant/resolve/direct/bar_pattern.hpp"

namespace pliant {

inline constexpr std::size_t lane_count = 8;  ///< walkers that are resolved at once

/// Bit l is the truth about lane l.
using LaneMask = std::uint8_t;
inline constexpr LaneMask all_lanes = 0xff;

/// A number of each walker.
struct alignas(64) LaneValue {
  double of[lane_count];
};
/// A point (Angstrom) of each walker.
struct LaneVector {
  LaneValue x, y, z;
};

/// A bar to look at.
struct LaneBar {
  std::uint32_t a, b;
  double rest, allowed;  ///< Angstrom; allowed is the largest |length - rest| of a whole bar
  /// Where |length^2 - rest^2| as computed is below `surely_whole` (Angstrom^2), |length - rest| as
  /// computed is within `allowed`, whatever the rounding.
  double rest_squared, surely_whole;
};

LaneBar lane_bar(std::uint32_t a, std::uint32_t b, double rest, double allowed);

/// A bar of a sweep, with the shares of its ends.
struct LaneVisit {
  std::uint32_t near, far;
  double rest, allowed, near_share, far_share;
};

/// Consecutive things in memory (std::span brings functions that would be compiled for each level).
template <class Thing>
struct LaneList {
  const Thing* begin;
  std::size_t size;
};

/// Residuals of all bars, one of each walker.
struct LaneResiduals {
  double max_relative[lane_count];
  double sum_of_squares[lane_count];  ///< of the relative errors, where asked for
  std::uint32_t worst_bar[lane_count];
  LaneMask within, finite;
};

/// Scratch of one part, each beginning with the part's first joint, bar or entry.
struct LaneRoom {
  LaneVector *x, *best;                    ///< of joints
  LaneVector *directions, *along;          ///< of bars
  LaneValue *excess, *diagonal, *inverse;  ///< of bars
  LaneValue* lower;                        ///< of entries
};

/// What `nearest` needs beside a LaneRoom: scratch and scales, each beginning with the part's first
/// joint or bar.
struct LaneNearestRoom {
  LaneVector *broken, *restoring, *sliding, *residual, *direction, *curved;  ///< of joints
  LaneValue *lambda, *bars;                                                  ///< of bars
  const double *masses, *allowed;  ///< JointScales of the part's joints
};

/// How Newton's method on a part went.
struct LaneResult {
  LaneMask whole;  ///< not whole: that walker is to be resolved alone
  double iterations[lane_count], dropped_bars[lane_count];
  double off_nearest[lane_count];  ///< Angstrom; of `nearest` alone, -1 where not looked for
};

struct LaneBodyKernels;  // lane_bodies.hpp

/// The kernels of one level of instructions.
struct LaneKernels {
  const char* level;  ///< "portable", "v2" (of x86-64: SSE4.2), "v3" (AVX2), "v4" (AVX-512)

  /// out[i] = (rows[0][i], ..., rows[7][i]) for i < count; rows are of walkers.
  void (*gather)(const double* const* rows, std::size_t count, LaneValue* out);
  /// The reverse; a null row is left out.
  void (*scatter)(const LaneValue* in, std::size_t count, double* const* rows);

  /// Those of the lanes `among` in which every bar is within what is allowed.
  LaneMask (*find_whole)(LaneList<LaneBar> bars, const LaneVector* x, LaneMask among);
  /// As find_whole of all lanes, where most are: hardly any bar needs a square root to be known.
  LaneMask (*confirm_whole)(LaneList<LaneBar> bars, const LaneVector* x);
  LaneResiduals (*measure)(LaneList<LaneBar> bars, const LaneVector* x, bool sum_squares);

  /// Carries the far ends (b) of bridges, one after another. Returns the lanes in which each was
  /// whole then, and its joints not in one place before.
  LaneMask (*carry)(LaneList<LaneBar> bridges, LaneVector* x);
  /// Projects each bar once. Returns lanes with coincident joints.
  LaneMask (*sweep)(LaneList<LaneVisit> visits, bool backwards, LaneVector* x);
  /// As find_whole. Begins at `hint` and leaves there where it ended; adds lanes with a length that
  /// is not finite to `not_finite`.
  LaneMask (*look)(LaneList<LaneVisit> visits, const LaneVector* x, LaneMask among,
                   std::size_t& hint, LaneMask& not_finite);

  /// One block of technique `blocks`: BarNewton::make_whole without damping, on framework positions
  /// `x`; walkers that were not made whole have their last positions there.
  LaneResult (*block_newton)(const BarPattern& part, const LaneRoom& room, LaneVector* x);
  /// One part of technique `shake`; `reference` of the framework, or null.
  LaneResult (*shake)(const BarPattern& part, const LaneRoom& room, const LaneVector* reference,
                      std::int64_t most_iterations, LaneVector* x);
  /// One part of technique `newton`: NearestPoint::find as far as NearestPoint::iterate.
  LaneResult (*nearest)(const BarPattern& part, const LaneRoom& room,
                        const LaneNearestRoom& nearest_room, std::int64_t most_iterations,
                        LaneVector* x);

  const LaneBodyKernels* bodies;  ///< of technique `froda`
};

/// All levels that this build holds and this processor knows, the best one first.
std::span<const LaneKernels* const> lane_levels();

}  // namespace pliant
