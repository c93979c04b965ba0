// SPDX-License-Identifier: MIT
// Newton's method on bars in lanes, as BarNewton (blocks) and ShakeSolver do it; a part of
// lane_level.cpp. Technique `newton` is in lane_nearest_kernels.hpp.
#pragma once

#include "pliant/resolve/lanes/lane_part.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

LaneResult result_of(Mask whole, Lanes iterations, Lanes dropped) {
  LaneResult result;
  result.whole = whole.bits();
  __builtin_memcpy(&result.iterations, &iterations, sizeof iterations);
  __builtin_memcpy(&result.dropped_bars, &dropped, sizeof dropped);
  const Lanes none = -1.0;
  __builtin_memcpy(&result.off_nearest, &none, sizeof none);
  return result;
}

/// As BarNewton::step. Returns the new error in units of what is allowed; infinite if it cannot go
/// on.
PLIANT_LANE_INLINE Lanes newton_step(Part& part) {
  part.factor(part.directions);
  part.move(part.directions);
  const Errors errors = part.measure();
  const Lanes beyond = 1.0 + 0x1p-52;
  const Lanes error = select(errors.whole, min(errors.worst, 1.0), max(errors.worst, beyond));
  return select(errors.finite & ~errors.coincident, error, infinity);
}

/// As BarNewton::make_whole, except what follows BarNewton::iterate.
LaneResult block_newton(const BarPattern& pattern, const LaneRoom& room, LaneVector* positions) {
  Part part(pattern, room);
  part.take(vectors(positions));
  const Errors errors = part.measure();
  Lanes error = errors.worst, best = select(errors.whole, 0.0, error);
  Lanes bad_steps = 0.0, iterations = 0.0, dropped = 0.0;
  Mask active = errors.finite & ~errors.coincident & ~errors.whole;
  const Mask hopeless = ~(errors.whole & errors.finite) & ~active;
  for (;;) {
    active &= (best > 1.0) & (error < infinity);
    if (active.bits() == 0) break;
    error = newton_step(part);
    iterations += select(active, 1.0, 0.0);
    dropped = select(active, part.dropped, dropped);
    const Mask bad = active & ~(error < Lanes(0.9) * best);
    bad_steps += select(bad, 1.0, 0.0);
    active &= !(bad & (bad_steps > double(newton_bad_steps)));
    const Mask better = active & (error < best);
    best = select(better, error, best);
    if (better.bits() != 0) part.keep_best(better);
  }
  part.give_best(vectors(positions));
  return result_of(~hopeless & (best <= 1.0), iterations, dropped);
}

/// Directions of the bars at the reference, where they have one.
void take_directions(Part& part, const LaneVec3* reference) {
  const BarPattern& pattern = part.pattern;
  for (std::uint32_t k = pattern.bars.begin, i = 0; k < pattern.bars.end; ++k, ++i) {
    part.along[i] = part.directions[i];
    if (reference == nullptr) continue;
    const EquationEnds ends = pattern.ends[k];
    const LaneVec3 d =
        reference[pattern.frame_joints[ends.b]] - reference[pattern.frame_joints[ends.a]];
    part.along[i] = select(norm_squared(d) >= least_squared_length, d, part.directions[i]);
  }
}

/// One step along the directions of the reference, as ShakeSolver::step.
PLIANT_LANE_INLINE void shake_step(Part& part) {
  for (std::uint32_t i = 0; i < part.pattern.bars.size(); ++i)
    part.excess[i] *= norm_squared(part.along[i]) / dot(part.along[i], part.directions[i]);
  part.move(part.along);
}

/// Steps until a walker is whole or gains no more, as ShakeSolver::iterate.
LaneResult shake(const BarPattern& pattern, const LaneRoom& room, const LaneVector* reference,
                 std::int64_t most_iterations, LaneVector* positions) {
  Part part(pattern, room);
  part.take(vectors(positions));
  Errors errors = part.measure();
  Mask whole = errors.whole, active = ~errors.whole & errors.finite & ~errors.coincident;
  if (active.bits() != 0) {
    take_directions(part, reference == nullptr ? nullptr : vectors(reference));
    part.factor(part.along);
  }
  const Lanes dropped = select(active, part.dropped, 0.0);
  Lanes best = infinity, bad_steps = 0.0, iterations = 0.0;
  for (std::int64_t left = most_iterations;; --left) {
    const Mask made = active & errors.whole;
    if (made.bits() != 0) part.keep_best(made);
    whole |= made;
    active &= ~errors.whole & errors.finite & ~errors.coincident;
    const Mask bad = active & ~(errors.worst < Lanes(0.9) * best);
    bad_steps += select(bad, 1.0, 0.0);
    active &= !(bad & (bad_steps > double(shake_bad_steps)));
    best = min(best, errors.worst);
    if (left == 0 || active.bits() == 0) break;
    shake_step(part);
    iterations += select(active, 1.0, 0.0);
    errors = part.measure();
  }
  part.give_best(vectors(positions));
  return result_of(whole, iterations, dropped);
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
