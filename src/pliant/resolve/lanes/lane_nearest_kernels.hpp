// SPDX-License-Identifier: MIT
// The nearest whole positions in lanes, as NearestPoint::iterate finds them, which is enough for
// almost every walker; a part of lane_level.cpp.
#pragma once

#include "pliant/resolve/lanes/lane_bar_newton_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

/// A part during the search for its nearest point. Comments are in NearestPoint.
struct Nearest {
  Part part;
  const double *masses, *allowed;
  LaneVec3 *broken, *restoring, *sliding, *residual, *direction, *curved;
  Lanes *lambda, *bars;

  Nearest(const BarPattern& of, const LaneRoom& room, const LaneNearestRoom& own)
      : part(of, room),
        masses(own.masses),
        allowed(own.allowed),
        broken(vectors(own.broken)),
        restoring(vectors(own.restoring)),
        sliding(vectors(own.sliding)),
        residual(vectors(own.residual)),
        direction(vectors(own.direction)),
        curved(vectors(own.curved)),
        lambda(numbers(own.lambda)),
        bars(numbers(own.bars)) {}

  std::uint32_t joint_count() const { return part.pattern.joints.size(); }

  template <class Change>
  PLIANT_LANE_INLINE void each_joint(Change change) const {
    for (std::uint32_t j = 0; j < joint_count(); ++j) change(j);
  }
  void clear(LaneVec3* v) const {
    each_joint([&](std::uint32_t j) { v[j] = {0.0, 0.0, 0.0}; });
  }
  void add(const LaneVec3* v, LaneVec3* out) const {
    each_joint([&](std::uint32_t j) { out[j] += v[j]; });
  }
  void copy(const LaneVec3* from, LaneVec3* to) const {
    each_joint([&](std::uint32_t j) { to[j] = from[j]; });
  }

  void solve(Lanes* b) const {
    const PartRange columns = part.pattern.bars;
    solve_columns<Lanes>(part.pattern.ldl, columns.begin, columns.end, part.inverse, part.lower, b);
  }
  void project(LaneVec3* v) const {
    stretch_bars<Lanes, LaneVec3>(part.pattern, part.directions, v, bars);
    solve(bars);
    pull_joints<Lanes, LaneVec3>(part.pattern, part.directions, bars, v);
  }
  Lanes product(const LaneVec3* v, const LaneVec3* w) const {
    return weighted_product<Lanes, LaneVec3>(masses, v, w, joint_count());
  }
  Lanes asked(const LaneVec3* move) const {
    return sqrt(asked_squared<Lanes, LaneVec3>(allowed, part.x, move, joint_count()));
  }
  Lanes largest(const LaneVec3* move) const {
    Lanes squared = 0.0;
    each_joint([&](std::uint32_t j) { squared = max(squared, norm_squared(move[j])); });
    return sqrt(squared);
  }

  void find_moves() {
    part.factor(part.directions);
    solve(part.excess);
    clear(restoring);
    pull_joints<Lanes, LaneVec3>(part.pattern, part.directions, part.excess, restoring);
    each_joint([&](std::uint32_t j) { residual[j] = part.x[j] - broken[j]; });
    project(residual);
    for (std::uint32_t i = 0; i < part.pattern.bars.size(); ++i) lambda[i] = -bars[i];
    find_sliding_move();
  }

  Mask is_loaded() const {
    Mask any = Mask::all(false);
    for (std::uint32_t i = 0; i < part.pattern.bars.size(); ++i)
      any |= (lambda[i] < 0.0) | ~(lambda[i] <= 0.0);
    return any;
  }

  void find_sliding_move() {
    clear(sliding);
    Mask going = is_loaded();
    if (going.bits() == 0) return;
    clear(curved);
    bend_joints<Lanes, LaneVec3>(part.pattern, lambda, restoring, curved);
    project(curved);
    add(curved, residual);
    each_joint([&](std::uint32_t j) {
      direction[j] = LaneVec3{0.0, 0.0, 0.0} + Lanes(-1.0) * residual[j];
    });
    Lanes squared = product(residual, residual);
    const Lanes least = Lanes(inner_accuracy * inner_accuracy) * squared;
    for (int i = 0; i < most_inner_iterations; ++i) {
      going &= squared > least;
      if (going.bits() == 0) return;
      search(going, squared);
    }
  }

  void search(Mask& going, Lanes& squared) {
    copy(direction, curved);
    bend_joints<Lanes, LaneVec3>(part.pattern, lambda, direction, curved);
    const Lanes curvature = product(direction, curved);
    const Lanes step = select(curvature > 0.0, squared / curvature, infinity);
    const Mask within = abs(step) < infinity, ends = going & ~within;
    if (ends.bits() != 0) slide(ends, select(product(sliding, sliding) > 0.0, 0.0, 1.0));
    going &= within;
    if (going.bits() == 0) return;
    slide(going, step);
    each_joint([&](std::uint32_t j) { residual[j] += step * curved[j]; });
    project(residual);
    const Lanes next = product(residual, residual);
    each_joint(
        [&](std::uint32_t j) { direction[j] = (next / squared) * direction[j] - residual[j]; });
    squared = next;
  }

  void slide(Mask where, Lanes step) const {
    each_joint([&](std::uint32_t j) {
      sliding[j] = select(where, sliding[j] + step * direction[j], sliding[j]);
    });
  }

  /// NearestPoint::polish of the lanes `done`, into part.best; does not change x.
  void polish(Mask done, const Errors& before) {
    copy(part.x, curved);
    add(restoring, part.x);
    add(sliding, part.x);
    const Errors after = part.measure();
    const Mask worse = ~after.whole | (after.worst > max(before.worst, 0.5));
    each_joint([&](std::uint32_t j) {
      part.best[j] = select(done, select(worse, curved[j], part.x[j]), part.best[j]);
      part.x[j] = curved[j];
    });
  }
};

LaneResult nearest(const BarPattern& pattern, const LaneRoom& room, const LaneNearestRoom& own_room,
                   std::int64_t most_iterations, LaneVector* positions) {
  Nearest at(pattern, room, own_room);
  Part& part = at.part;
  part.take(vectors(positions));
  at.copy(part.x, at.broken);
  Errors errors = part.measure();
  Mask whole = errors.whole, active = ~errors.whole & errors.finite & ~errors.coincident;
  Lanes least = infinity, bad_steps = 0.0, iterations = 0.0, dropped = 0.0, off_nearest = -1.0;
  for (std::int64_t left = most_iterations; left > 0 && active.bits() != 0; --left) {
    at.find_moves();
    iterations += select(active, 1.0, 0.0);
    dropped = select(active, part.dropped, dropped);
    off_nearest = select(active, at.largest(at.sliding), off_nearest);
    const Mask done = active & errors.whole & (at.asked(at.sliding) <= 1.0);
    if (done.bits() != 0) at.polish(done, errors);
    whole |= done;
    at.add(at.sliding, at.restoring);
    const Lanes size = at.asked(at.restoring);
    const Mask bad = active & ~(size < Lanes(0.9) * least);
    bad_steps += select(bad, 1.0, 0.0);
    active &= ~(done | (bad & (bad_steps > double(nearest_bad_steps))));
    least = min(least, size);
    at.add(at.restoring, part.x);
    errors = part.measure();
    active &= errors.finite & ~errors.coincident;
  }
  part.give_best(vectors(positions));
  LaneResult result = result_of(whole, iterations, dropped);
  __builtin_memcpy(&result.off_nearest, &off_nearest, sizeof off_nearest);
  return result;
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
