// SPDX-License-Identifier: MIT
// Operations on eight walkers at once (SIMD lanes), compiled for several levels of instructions, of
// which the best for this processor is taken at run time. All levels give the same bits.
//
// Positions of walkers in lanes are LaneVectors: x of all eight, then y, then z. A kernel handles
// the common case; if a walker needs more (coincident joints, a block that Newton's method does not
// make whole at once), the kernel says so, and that walker is resolved alone from its start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "pliant/resolve/equations/bar_pattern.hpp"

namespace pliant {

inline constexpr std::size_t lane_count = 8;  ///< walkers that are resolved at once

/// Bit l is the truth value in lane l.
using LaneMask = std::uint8_t;
inline constexpr LaneMask all_lanes = 0xff;

/// A number for each walker.
struct alignas(64) LaneValue {
  double of[lane_count];
};
/// A point (Angstrom) for each walker.
struct LaneVector {
  LaneValue x, y, z;
};

/// A bar to be checked.
struct LaneBar {
  std::uint32_t a, b;
  double rest, allowed;  ///< Angstrom; allowed is the largest |length - rest| of a whole bar
  /// If |length^2 - rest^2| as computed is below `surely_whole` (Angstrom^2), |length - rest| as
  /// computed is within `allowed`, whatever the rounding.
  double rest_squared, surely_whole;
};

LaneBar lane_bar(std::uint32_t a, std::uint32_t b, double rest, double allowed);

/// A bar of a sweep, with the shares of its ends.
struct LaneVisit {
  std::uint32_t near, far;
  double rest, allowed, near_share, far_share;
};

/// A squared distance (Angstrom^2) that two of a few points are to have.
struct LaneDistance {
  std::uint32_t i, j;
  double square;
};

/// How many LaneValues are scratch of `approach`.
constexpr std::size_t approach_room(std::size_t distances, std::size_t points) {
  const std::size_t equations = distances > 3 * points ? 3 * points : distances;
  return (equations + 1) * equations + 4 * distances;
}

/// Consecutive things in memory (std::span brings functions that would be compiled for each level).
template <class Thing>
struct LaneList {
  const Thing* begin;
  std::size_t size;
};

/// Residuals of all bars, for each walker.
struct LaneResiduals {
  double max_relative[lane_count];
  double sum_of_squares[lane_count];  ///< of the relative errors, if asked for
  std::uint32_t worst_bar[lane_count];
  LaneMask within, finite;
};

/// Scratch of one part; each array begins with the part's first joint, bar or entry.
struct LaneRoom {
  LaneVector *x, *best;                    ///< of joints
  LaneVector *directions, *along;          ///< of bars
  LaneValue *excess, *diagonal, *inverse;  ///< of bars
  LaneValue* lower;                        ///< of entries
};

/// Scratch and scales of `nearest` besides a LaneRoom; each array begins with the part's first
/// joint or bar.
struct LaneNearestRoom {
  LaneVector *broken, *restoring, *sliding, *residual, *direction, *curved;  ///< of joints
  LaneValue *lambda, *bars;                                                  ///< of bars
  const double *masses, *allowed;  ///< JointScales of the part's joints
};

/// The result of Newton's method on a part.
struct LaneResult {
  LaneMask whole;  ///< the others are to be resolved alone
  double iterations[lane_count], dropped_bars[lane_count];
  double off_nearest[lane_count];  ///< Angstrom; only from `nearest`, -1 if not sought
};

struct LaneBodyKernels;  // lane_bodies.hpp

/// The kernels of one level of instructions.
struct LaneKernels {
  const char* level;  ///< "portable", "v2" (of x86-64: SSE4.2), "v3" (AVX2), "v4" (AVX-512)

  /// out[i] = (rows[0][i], ..., rows[7][i]) for i < count; each row belongs to a walker.
  void (*gather)(const double* const* rows, std::size_t count, LaneValue* out);
  /// The reverse; null rows are skipped.
  void (*scatter)(const LaneValue* in, std::size_t count, double* const* rows);

  /// The lanes of `among` in which every bar is within what is allowed.
  LaneMask (*find_whole)(LaneList<LaneBar> bars, const LaneVector* x, LaneMask among);
  /// As find_whole for all lanes, when most bars are whole: hardly any bar needs a square root.
  LaneMask (*confirm_whole)(LaneList<LaneBar> bars, const LaneVector* x);
  LaneResiduals (*measure)(LaneList<LaneBar> bars, const LaneVector* x, bool sum_squares);

  /// Carries the far ends (b) of bridges, one after another. Returns the lanes in which each was
  /// whole afterwards and had no coincident joints before.
  LaneMask (*carry)(LaneList<LaneBar> bridges, LaneVector* x);
  /// Projects each bar once. Returns the lanes with coincident joints.
  LaneMask (*sweep)(LaneList<LaneVisit> visits, bool backwards, LaneVector* x);
  /// As find_whole. Begins at `hint` and stores there where it ended; adds lanes with a length that
  /// is not finite to `not_finite`.
  LaneMask (*look)(LaneList<LaneVisit> visits, const LaneVector* x, LaneMask among,
                   std::size_t& hint, LaneMask& not_finite);

  /// One block of technique `blocks`: BarNewton::make_whole without damping, on framework positions
  /// `x`; walkers that are not whole have their last positions there.
  LaneResult (*block_newton)(const BarPattern& part, const LaneRoom& room, LaneVector* x);
  /// One part of technique `shake`; `reference` has the framework's joints, or is null.
  LaneResult (*shake)(const BarPattern& part, const LaneRoom& room, const LaneVector* reference,
                      std::int64_t most_iterations, LaneVector* x);
  /// One part of technique `newton`: NearestPoint::solve without what follows
  /// NearestPoint::iterate.
  LaneResult (*nearest)(const BarPattern& part, const LaneRoom& room,
                        const LaneNearestRoom& nearest_room, std::int64_t most_iterations,
                        LaneVector* x);

  /// So many steps of approach() of conformers/rings/distance_fit.hpp. Returns the lanes in which
  /// each could be made; `room` has approach_room() values.
  LaneMask (*approach)(LaneList<LaneDistance> wanted, std::size_t points, double damped, int steps,
                       LaneValue* room, LaneVector* x);

  const LaneBodyKernels* bodies;  ///< for technique `froda`
};

/// All levels of this build that this processor can run, the best one first.
std::span<const LaneKernels* const> lane_levels();

}  // namespace pliant
