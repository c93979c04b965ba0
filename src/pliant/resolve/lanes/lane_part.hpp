// SPDX-License-Identifier: MIT
// One part of BarEquations in lanes, with the operations of BarEquations and SparseLdl; a part of
// lane_level.cpp.
#pragma once

#include "pliant/resolve/equations/bar_loops.hpp"
#include "pliant/resolve/lanes/lane_bar_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

/// Results of BarEquations::measure in each lane.
struct Errors {
  Lanes worst = 0.0;
  Mask whole = Mask::all(true), finite = Mask::all(true), coincident = Mask::all(false);
};

/// One part with its scratch.
struct Part {
  const BarPattern& pattern;
  LaneVec3 *x, *best, *directions, *along;
  Lanes *excess, *diagonal, *inverse, *lower;
  Lanes dropped = 0.0;  ///< of the last factorization

  Part(const BarPattern& of, const LaneRoom& room)
      : pattern(of),
        x(vectors(room.x)),
        best(vectors(room.best)),
        directions(vectors(room.directions)),
        along(vectors(room.along)),
        excess(numbers(room.excess)),
        diagonal(numbers(room.diagonal)),
        inverse(numbers(room.inverse)),
        lower(numbers(room.lower)) {}

  void take(const LaneVec3* from) {
    for (std::uint32_t j = 0; j < pattern.joints.size(); ++j)
      best[j] = x[j] = from[pattern.frame_joints[pattern.joints.begin + j]];
  }

  void give_best(LaneVec3* to) const {
    for (std::uint32_t j = 0; j < pattern.joints.size(); ++j)
      if (pattern.weights[pattern.joints.begin + j] > 0.0)
        to[pattern.frame_joints[pattern.joints.begin + j]] = best[j];
  }

  void keep_best(Mask where) {
    for (std::uint32_t j = 0; j < pattern.joints.size(); ++j)
      best[j] = select(where, x[j], best[j]);
  }

  Errors measure() {
    Errors errors;
    const std::uint32_t first_joint = pattern.joints.begin;
    for (std::uint32_t k = pattern.bars.begin, i = 0; k < pattern.bars.end; ++k, ++i) {
      const EquationEnds ends = pattern.ends[k];
      const LaneVec3 delta = x[ends.b - first_joint] - x[ends.a - first_joint];
      const Lanes squared = norm_squared(delta), length = sqrt(squared);
      const Lanes error = length - pattern.rests[k], off = abs(error);
      directions[i] = delta;
      excess[i] = length * error;
      errors.whole &= off <= pattern.allowed[k];
      errors.finite &= length < infinity;
      errors.coincident |= squared < least_squared_length;
      errors.worst = max(errors.worst, off * pattern.per_allowed[k]);
    }
    return errors;
  }

  void factor(const LaneVec3* of) {
    fill_gram<Lanes, LaneVec3>(pattern, of, 0.0, diagonal, lower);
    dropped = 0.0;
    factor_columns<Lanes>(pattern.ldl, pattern.bars.begin, pattern.bars.end, diagonal, inverse,
                          lower, [this](Mask drops) { dropped += select(drops, 1.0, 0.0); });
  }

  void move(const LaneVec3* along_bars) {
    solve_columns<Lanes>(pattern.ldl, pattern.bars.begin, pattern.bars.end, inverse, lower, excess);
    pull_joints<Lanes, LaneVec3>(pattern, along_bars, excess, x);
  }
};

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
