// SPDX-License-Identifier: MIT
// Kernels that take one bar after another; a part of lane_level.cpp.
#pragma once

#include "pliant/base/vec3.hpp"
#include "pliant/resolve/lanes/lane_memory_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

constexpr double infinity = __builtin_huge_val();
constexpr std::size_t look_ahead = 16;  ///< bars between two checks whether to go on

template <class Bar>
PLIANT_LANE_INLINE Lanes error_of(const Bar& bar, const LaneVec3& from, const LaneVec3& to) {
  return abs(sqrt(norm_squared(to - from)) - bar.rest);
}

LaneMask find_whole(LaneList<LaneBar> bars, const LaneVector* positions, LaneMask among) {
  const LaneVec3* x = vectors(positions);
  const LaneBar* bar = bars.begin;
  const LaneBar* const end = bar + bars.size;
  Mask whole = Mask::of(among);
  while (bar != end && whole.bits() != 0) {
    const LaneBar* const stop = end - bar > std::ptrdiff_t(look_ahead) ? bar + look_ahead : end;
    for (; bar != stop; ++bar) whole &= error_of(*bar, x[bar->a], x[bar->b]) <= bar->allowed;
  }
  return whole.bits();
}

LaneMask confirm_whole(LaneList<LaneBar> bars, const LaneVector* positions) {
  const LaneVec3* x = vectors(positions);
  Mask whole = Mask::all(true);
  const LaneBar* const end = bars.begin + bars.size;
  for (const LaneBar* bar = bars.begin; bar != end; ++bar) {
    const Lanes squared = norm_squared(x[bar->b] - x[bar->a]);
    const Mask sure = abs(squared - bar->rest_squared) < bar->surely_whole;
    if ((~sure).bits() == 0) continue;
    whole &= abs(sqrt(squared) - bar->rest) <= bar->allowed;
  }
  return whole.bits();
}

template <bool sum_squares>
LaneResiduals measure_bars(LaneList<LaneBar> bars, const LaneVec3* x) {
  LaneResiduals found{};
  Lanes most = 0.0, near_most = 0.0, sum = 0.0;
  Mask within = Mask::all(true), finite = Mask::all(true);
  for (std::size_t k = 0; k < bars.size; ++k) {
    const LaneBar& bar = bars.begin[k];
    const Lanes error = error_of(bar, x[bar.a], x[bar.b]);
    within &= error <= bar.allowed;
    finite &= error < infinity;
    // Divides only where the quotient may be the largest so far.
    if (!sum_squares && (error > near_most * bar.rest).bits() == 0) continue;
    const Lanes relative = error / bar.rest;
    const Mask more = relative > most;
    if (sum_squares) sum += relative * relative;
    most = select(more, relative, most);
    near_most = most * (1.0 - 0x1p-40);
    for (LaneMask left = more.bits(); left != 0; left = LaneMask(left & (left - 1)))
      found.worst_bar[__builtin_ctz(left)] = static_cast<std::uint32_t>(k);
  }
  __builtin_memcpy(&found.max_relative, &most, sizeof most);
  __builtin_memcpy(&found.sum_of_squares, &sum, sizeof sum);
  found.within = within.bits();
  found.finite = finite.bits();
  return found;
}

LaneResiduals measure(LaneList<LaneBar> bars, const LaneVector* positions, bool sum_squares) {
  const LaneVec3* x = vectors(positions);
  return sum_squares ? measure_bars<true>(bars, x) : measure_bars<false>(bars, x);
}

/// Checks that bars are whole while it carries them: both ends are at hand, and the arithmetic
/// waits for square roots and divisions, so that this costs next to nothing, unlike a separate
/// pass.
LaneMask carry(LaneList<LaneBar> bridges, LaneVector* positions) {
  LaneVec3* x = vectors(positions);
  Mask well = Mask::all(true);
  const LaneBar* const end = bridges.begin + bridges.size;
  for (const LaneBar* bridge = bridges.begin; bridge != end; ++bridge) {
    const LaneVec3 near = x[bridge->a], delta = x[bridge->b] - near;
    const Lanes squared = norm_squared(delta);
    const Lanes d = sqrt(squared);
    const LaneVec3 far = x[bridge->b] - ((d - bridge->rest) / d) * delta;
    x[bridge->b] = far;
    well &= squared >= least_squared_length;
    const Lanes made = norm_squared(far - near);
    const Mask sure = abs(made - bridge->rest_squared) < bridge->surely_whole;
    if ((~sure).bits() != 0) [[unlikely]]
      well &= abs(sqrt(made) - bridge->rest) <= bridge->allowed;
  }
  return well.bits();
}

PLIANT_LANE_INLINE void project(const LaneVisit& visit, LaneVec3* x, Mask& coincident) {
  const LaneVec3 delta = x[visit.far] - x[visit.near];
  const Lanes squared = norm_squared(delta);
  coincident |= squared < least_squared_length;
  const Lanes d = sqrt(squared);
  const LaneVec3 excess = ((d - visit.rest) / d) * delta;
  x[visit.near] += Lanes(visit.near_share) * excess;
  x[visit.far] -= Lanes(visit.far_share) * excess;
}

LaneMask sweep(LaneList<LaneVisit> visits, bool backwards, LaneVector* positions) {
  Mask coincident = Mask::all(false);
  const LaneVisit* const begin = visits.begin;
  const LaneVisit* const end = begin + visits.size;
  if (backwards) {
    for (const LaneVisit* visit = end; visit != begin;)
      project(*--visit, vectors(positions), coincident);
  } else {
    for (const LaneVisit* visit = begin; visit != end; ++visit)
      project(*visit, vectors(positions), coincident);
  }
  return coincident.bits();
}

/// Returns the lanes of `whole` that are still whole after visits [from, to); sets `from` to the
/// last visit.
Mask look_at(const LaneVisit* visits, std::size_t& from, std::size_t to, const LaneVec3* x,
             Mask whole, Mask& infinite) {
  while (from < to && whole.bits() != 0) {
    const std::size_t stop = to - from > look_ahead ? from + look_ahead : to;
    const std::size_t begin = from;
    for (; from < stop; ++from) {
      const LaneVisit& visit = visits[from];
      const Lanes error = error_of(visit, x[visit.near], x[visit.far]);
      whole &= error <= visit.allowed;
      infinite |= ~(error < infinity);
    }
    if (whole.bits() == 0) from = begin;
    if (whole.bits() == 0) break;
  }
  return whole;
}

LaneMask look(LaneList<LaneVisit> visits, const LaneVector* positions, LaneMask among,
              std::size_t& hint, LaneMask& not_finite) {
  if (hint >= visits.size) hint = 0;
  Mask infinite = Mask::all(false);
  std::size_t at = hint;
  Mask whole =
      look_at(visits.begin, at, visits.size, vectors(positions), Mask::of(among), infinite);
  if (whole.bits() != 0) {
    const std::size_t end = hint;
    at = 0;
    whole = look_at(visits.begin, at, end, vectors(positions), whole, infinite);
  }
  hint = at;
  not_finite = LaneMask(not_finite | infinite.bits());
  return whole.bits();
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
