// SPDX-License-Identifier: MIT
// The kernels of lane_kernels.hpp, compiled once for each level of instructions. Only internal
// functions and the templates of bar_loops.hpp on types of this level: an inline function of
// another header compiled here could end up in code for every processor.
#include "pliant/resolve/bar_loops.hpp"
#include "pliant/resolve/lane_kernels.hpp"
#include "pliant/resolve/lanes.hpp"

#define PLIANT_LANE_TEXT_OF(name) #name
#define PLIANT_LANE_TEXT(name) PLIANT_LANE_TEXT_OF(name)

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

constexpr double infinity = __builtin_huge_val();
constexpr double least_squared_length = 1e-300;  ///< as in project_bar.hpp
constexpr std::size_t look_ahead = 16;           ///< bars between two questions whether to go on

LaneVec3* vectors(LaneVector* x) { return reinterpret_cast<LaneVec3*>(x); }
const LaneVec3* vectors(const LaneVector* x) { return reinterpret_cast<const LaneVec3*>(x); }
Lanes* numbers(LaneValue* x) { return reinterpret_cast<Lanes*>(x); }
PLIANT_LANE_INLINE Doubles load(const double* from) {
  Doubles row;
  __builtin_memcpy(&row, from, sizeof row);
  return row;
}
PLIANT_LANE_INLINE void store(const Doubles& row, double* to) {
  __builtin_memcpy(to, &row, sizeof row);
}

/// A matrix of doubles as wide as a register, by rows, transposed.
PLIANT_LANE_INLINE void transpose(Doubles (&r)[width]) {
  Doubles s[width];
#if PLIANT_LANE_BYTES == 64
  Doubles t[8];
  for (int i = 0; i < 8; i += 2) {
    s[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    s[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
    for (int j = i; j < i + 2; ++j) {
      t[j] = __builtin_shufflevector(s[j], s[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      t[j + 2] = __builtin_shufflevector(s[j], s[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int j = 0; j < 4; ++j) {
    r[j] = __builtin_shufflevector(t[j], t[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[j + 4] = __builtin_shufflevector(t[j], t[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#elif PLIANT_LANE_BYTES == 32
  for (int i = 0; i < 4; i += 2) {
    s[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 4, 2, 6);
    s[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 1, 5, 3, 7);
  }
  for (int j = 0; j < 2; ++j) {
    r[j] = __builtin_shufflevector(s[j], s[j + 2], 0, 1, 4, 5);
    r[j + 2] = __builtin_shufflevector(s[j], s[j + 2], 2, 3, 6, 7);
  }
#else
  s[0] = __builtin_shufflevector(r[0], r[1], 0, 2);
  s[1] = __builtin_shufflevector(r[0], r[1], 1, 3);
  r[0] = s[0];
  r[1] = s[1];
#endif
}

void gather(const double* const* rows, std::size_t count, LaneValue* to) {
  Lanes* const out = numbers(to);
  std::size_t i = 0;
  for (; i + width <= count; i += width)
    for (int piece = 0; piece < pieces; ++piece) {
      Doubles block[width];
      for (int k = 0; k < width; ++k) block[k] = load(rows[piece * width + k] + i);
      transpose(block);
      for (int k = 0; k < width; ++k) out[i + k].v[piece] = block[k];
    }
  for (; i < count; ++i)
    for (int lane = 0; lane < 8; ++lane) out[i].set(lane, rows[lane][i]);
}

void scatter(const LaneValue* from, std::size_t count, double* const* rows) {
  const Lanes* const in = reinterpret_cast<const Lanes*>(from);
  std::size_t i = 0;
  for (; i + width <= count; i += width)
    for (int piece = 0; piece < pieces; ++piece) {
      Doubles block[width];
      for (int k = 0; k < width; ++k) block[k] = in[i + k].v[piece];
      transpose(block);
      for (int k = 0; k < width; ++k)
        if (double* const row = rows[piece * width + k]) store(block[k], row + i);
    }
  for (; i < count; ++i)
    for (int lane = 0; lane < 8; ++lane)
      if (rows[lane] != nullptr) rows[lane][i] = in[i].get(lane);
}

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

LaneResiduals measure(LaneList<LaneBar> bars, const LaneVector* positions) {
  const LaneVec3* x = vectors(positions);
  LaneResiduals found{};
  Lanes most = 0.0, near_most = 0.0;
  Mask within = Mask::all(true), finite = Mask::all(true);
  for (std::size_t k = 0; k < bars.size; ++k) {
    const LaneBar& bar = bars.begin[k];
    const Lanes error = error_of(bar, x[bar.a], x[bar.b]);
    within &= error <= bar.allowed;
    finite &= error < infinity;
    // Divides only where the quotient may be the largest so far.
    if ((error > near_most * bar.rest).bits() == 0) continue;
    const Lanes relative = error / bar.rest;
    const Mask more = relative > most;
    most = select(more, relative, most);
    near_most = most * (1.0 - 0x1p-40);
    for (LaneMask left = more.bits(); left != 0; left = LaneMask(left & (left - 1)))
      found.worst_bar[__builtin_ctz(left)] = static_cast<std::uint32_t>(k);
  }
  __builtin_memcpy(&found.max_relative, &most, sizeof most);
  found.within = within.bits();
  found.finite = finite.bits();
  return found;
}

LaneMask carry(LaneList<LaneBridge> bridges, LaneVector* positions) {
  LaneVec3* x = vectors(positions);
  Mask coincident = Mask::all(false);
  const LaneBridge* const end = bridges.begin + bridges.size;
  for (const LaneBridge* bridge = bridges.begin; bridge != end; ++bridge) {
    const LaneVec3 delta = x[bridge->far] - x[bridge->near];
    const Lanes squared = norm_squared(delta);
    coincident |= squared < least_squared_length;
    const Lanes d = sqrt(squared);
    x[bridge->far] -= ((d - bridge->rest) / d) * delta;
  }
  return coincident.bits();
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

/// Lanes of `whole` that still are after visits [from, to); `from` becomes where that ended.
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

/// What BarEquations::measure finds, of each lane.
struct Errors {
  Lanes worst = 0.0;
  Mask whole = Mask::all(true), finite = Mask::all(true), coincident = Mask::all(false);
};

/// One part in its room.
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

LaneOutcome outcome_of(Mask whole, Lanes iterations, Lanes dropped) {
  LaneOutcome outcome;
  outcome.whole = whole.bits();
  __builtin_memcpy(&outcome.iterations, &iterations, sizeof iterations);
  __builtin_memcpy(&outcome.dropped_bars, &dropped, sizeof dropped);
  return outcome;
}

/// BarNewton::step: the new error in units of what is allowed, infinite where it cannot go on.
PLIANT_LANE_INLINE Lanes newton_step(Part& part) {
  part.factor(part.directions);
  part.move(part.directions);
  const Errors errors = part.measure();
  const Lanes beyond = 1.0 + 0x1p-52;
  const Lanes error = select(errors.whole, min(errors.worst, 1.0), max(errors.worst, beyond));
  return select(errors.finite & ~errors.coincident, error, infinity);
}

/// BarNewton::make_whole as far as BarNewton::iterate.
LaneOutcome newton(const BarPattern& pattern, const LaneRoom& room, LaneVector* positions) {
  constexpr double most_bad_steps = 3.0;
  Part part(pattern, room);
  part.take(vectors(positions));
  const Errors errors = part.measure();
  Lanes error = errors.worst, best = select(errors.whole, 0.0, error);
  Lanes bad_steps = 0.0, iterations = 0.0, dropped = 0.0;
  Mask active = errors.finite & ~errors.coincident & ~errors.whole;
  const Mask hopeless = ~errors.whole & ~active;
  for (;;) {
    active &= (best > 1.0) & (error < infinity);
    if (active.bits() == 0) break;
    error = newton_step(part);
    iterations += select(active, 1.0, 0.0);
    dropped = select(active, part.dropped, dropped);
    const Mask bad = active & ~(error < Lanes(0.9) * best);
    bad_steps += select(bad, 1.0, 0.0);
    active &= !(bad & (bad_steps > most_bad_steps));
    const Mask better = active & (error < best);
    best = select(better, error, best);
    if (better.bits() != 0) part.keep_best(better);
  }
  part.give_best(vectors(positions));
  return outcome_of(~hopeless & (best <= 1.0), iterations, dropped);
}

/// Directions of the bars at the reference, where they have one there.
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

/// ShakeSolver::step.
PLIANT_LANE_INLINE void shake_step(Part& part) {
  for (std::uint32_t i = 0; i < part.pattern.bars.size(); ++i)
    part.excess[i] *= norm_squared(part.along[i]) / dot(part.along[i], part.directions[i]);
  part.move(part.along);
}

/// ShakeSolver::iterate.
LaneOutcome shake(const BarPattern& pattern, const LaneRoom& room, const LaneVector* reference,
                  std::int64_t most_iterations, LaneVector* positions) {
  constexpr double most_bad_steps = 5.0;
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
    active &= !(bad & (bad_steps > most_bad_steps));
    best = min(best, errors.worst);
    if (left == 0 || active.bits() == 0) break;
    shake_step(part);
    iterations += select(active, 1.0, 0.0);
    errors = part.measure();
  }
  part.give_best(vectors(positions));
  return outcome_of(whole, iterations, dropped);
}

}  // namespace

extern const LaneKernels kernels;
const LaneKernels kernels = {PLIANT_LANE_TEXT(PLIANT_LANE_LEVEL) + 6,  // without "lanes_"
                             gather,
                             scatter,
                             find_whole,
                             measure,
                             carry,
                             sweep,
                             look,
                             newton,
                             shake};

}  // namespace pliant::PLIANT_LANE_LEVEL
