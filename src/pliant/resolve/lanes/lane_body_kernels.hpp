// SPDX-License-Identifier: MIT
// The kernels of lane_bodies.hpp; a part of lane_level.cpp. Comments are in ArticulatedPass and
// ArticulatedStep, which do the same operations.
#pragma once

#include "pliant/resolve/lanes/lane_twist_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

/// Moments of points.
struct Sums {
  Lanes xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
  LaneVec3 sum{0.0, 0.0, 0.0};

  PLIANT_LANE_INLINE void add(const LaneVec3& x) {
    sum += x;
    xx += x.x * x.x;
    yy += x.y * x.y;
    zz += x.z * x.z;
    xy += x.x * x.y;
    xz += x.x * x.z;
    yz += x.y * x.z;
  }
  PLIANT_LANE_INLINE void set(double n, Lanes* m) const {
    const LaneVec3& s = sum;
    const Lanes of[21] = {yy + zz, -xy, xx + zz, -xz, -yz, xx + yy, 0.0,  s.z, -s.y, n,  //
                          -s.z,    0.0, s.x,     0.0, n,   s.y,     -s.x, 0.0, 0.0,  0.0, n};
    for (int k = 0; k < 21; ++k) m[k] = of[k];
  }
};

PLIANT_LANE_INLINE void set_turns(const LaneBody& body, const LaneVec3* x, LaneTurn* turns) {
  const LaneVec3 through = x[body.a];
  if (body.turns == 1) {
    const LaneVec3 along = x[body.b] - through;
    const LaneVec3 axis = (Lanes(1.0) / sqrt(norm_squared(along))) * along;
    return set_twist(axis, cross(through, axis), numbers(turns[body.first_turn].s.of));
  }
  for (unsigned t = 0; t < body.turns; ++t) {
    const LaneVec3 axis{t == 0 ? 1.0 : 0.0, t == 1 ? 1.0 : 0.0, t == 2 ? 1.0 : 0.0};
    set_twist(axis, cross(through, axis), numbers(turns[body.first_turn + t].s.of));
  }
}

void gather_bodies(const LaneForest& forest, const LaneVector* places, const LaneVector* targets,
                   LaneMask has_targets, LaneTwist* forces) {
  const LaneVec3 *const x = vectors(places), *const to = vectors(targets);
  const Mask pulled = Mask::of(has_targets);
  const LaneVec3 none{0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < forest.bodies.size; ++k) {
    const LaneBody& body = forest.bodies.begin[k];
    Sums sums;
    LaneVec3 pull = none, moment = none;
    for (std::uint32_t at = body.first; at < body.last; ++at) {
      sums.add(x[at]);
      if (has_targets == 0) continue;
      const LaneVec3 force = to[at] - x[at];
      pull += force;
      moment += cross(x[at], force);
    }
    sums.set(body.last - body.first, numbers(forest.inertia[k].of));
    set_twist(select(pulled, moment, none), select(pulled, pull, none), numbers(forces[k].of));
    set_turns(body, x, forest.turns);
  }
}

void go_inward(const LaneForest& forest, LaneTwist* forces) {
  for (std::size_t k = forest.bodies.size; k-- > 0;) {
    const LaneBody& body = forest.bodies.begin[k];
    if (body.parent < 0) continue;
    Lanes *const m = numbers(forest.inertia[k].of), *const p = numbers(forces[k].of);
    for (std::uint32_t t = body.first_turn + body.turns; t-- > body.first_turn;) {
      LaneTurn& turn = forest.turns[t];
      Lanes *const s = numbers(turn.s.of), *const u = numbers(turn.u.of);
      multiply(m, s, u);
      const Lanes inverse =
          Lanes(1.0) / (sixfold(s, u) + forest.damping + lanes_of(forest.springs[t].weight));
      const Lanes force = sixfold(s, p) + lanes_of(forest.springs[t].force);
      *numbers(&turn.inverse) = inverse;
      *numbers(&turn.force) = force;
      add_scaled6(-force * inverse, u, p);
      Lanes* entry = m;
      for (int i = 0; i < 6; ++i) {
        const Lanes scaled = -inverse * u[i];
        for (int j = 0; j <= i; ++j) *entry++ += scaled * u[j];
      }
    }
    Lanes* const above = numbers(forest.inertia[body.parent].of);
    for (int i = 0; i < 21; ++i) above[i] += m[i];
    Lanes* const force_above = numbers(forces[body.parent].of);
    for (int i = 0; i < 6; ++i) force_above[i] += p[i];
  }
}

void push_inward(const LaneForest& forest, LaneMoves forces) {
  for (std::size_t k = forest.bodies.size; k-- > 0;) {
    const LaneBody& body = forest.bodies.begin[k];
    if (body.parent < 0) continue;
    Lanes* const p = numbers(forces.twists[k].of);
    for (std::uint32_t t = body.first_turn + body.turns; t-- > body.first_turn;) {
      LaneTurn& turn = forest.turns[t];
      const Lanes force = sixfold(numbers(turn.s.of), p) + lanes_of(forces.angles[t]);
      add_scaled6(-force * lanes_of(turn.inverse), numbers(turn.u.of), p);
      *numbers(&turn.force) = force;
    }
    Lanes* const above = numbers(forces.twists[body.parent].of);
    for (int i = 0; i < 6; ++i) above[i] += p[i];
  }
}

void go_outward(const LaneForest& forest, const LaneTwist* forces, LaneMoves out) {
  for (std::size_t k = 0; k < forest.bodies.size; ++k) {
    const LaneBody& body = forest.bodies.begin[k];
    Lanes* const v = numbers(out.twists[k].of);
    if (body.parent < 0) {
      solve_root(numbers(forest.inertia[k].of), numbers(forces[k].of), forest.square_unit, v);
      continue;
    }
    const Lanes* const carried = numbers(out.twists[body.parent].of);
    for (int i = 0; i < 6; ++i) v[i] = carried[i];
    for (std::uint32_t t = body.first_turn; t < body.first_turn + body.turns; ++t) {
      const LaneTurn& turn = forest.turns[t];
      const Lanes angle =
          (lanes_of(turn.force) - sixfold(numbers(turn.u.of), v)) * lanes_of(turn.inverse);
      *numbers(&out.angles[t]) = angle;
      add_scaled6(angle, numbers(turn.s.of), v);
    }
  }
}

LaneValue product(const LaneForest& forest, LaneMoves forces, LaneMoves moves) {
  Lanes sum = 0.0;
  for (std::size_t k = 0; k < forest.bodies.size; ++k)
    sum += sixfold(numbers(forces.twists[k].of), numbers(moves.twists[k].of));
  for (std::size_t t = 0; t < forest.turn_count; ++t)
    sum += lanes_of(forces.angles[t]) * lanes_of(moves.angles[t]);
  return value_of(sum);
}

LaneValue apply_matrix(const LaneForest& forest, const LaneVector* places, LaneMoves direction,
                       LaneTwist* image) {
  const LaneVec3* const x = vectors(places);
  Lanes sum = 0.0;
  for (std::size_t k = 0; k < forest.bodies.size; ++k) {
    const LaneBody& body = forest.bodies.begin[k];
    const Lanes* const twist = numbers(direction.twists[k].of);
    LaneVec3 pull{0.0, 0.0, 0.0}, moment{0.0, 0.0, 0.0};
    for (std::uint32_t at = body.first; at < body.last; ++at) {
      const LaneVec3 v = velocity(twist, x[at]);
      pull += v;
      moment += cross(x[at], v);
    }
    Lanes* const own = numbers(image[k].of);
    set_twist(moment, pull, own);
    sum += sixfold(own, twist);
  }
  for (std::size_t t = 0; t < forest.turn_count; ++t) {
    const Lanes angle = lanes_of(direction.angles[t]);
    sum += (Lanes(forest.damping) + lanes_of(forest.springs[t].weight)) * angle * angle;
  }
  return value_of(sum);
}

void resist(const LaneForest& forest, const LaneValue& step, const LaneValue* angles,
            LaneValue* forces) {
  const Lanes share = lanes_of(step);
  for (std::size_t t = 0; t < forest.turn_count; ++t)
    *numbers(&forces[t]) -=
        share * (Lanes(forest.damping) + lanes_of(forest.springs[t].weight)) * lanes_of(angles[t]);
}

LaneValue share_of(const LaneForest& forest, const LaneVector* places, LaneMoves moves,
                   const LaneValue& bound, double largest_turn) {
  const LaneVec3* const x = vectors(places);
  Lanes furthest = 0.0, widest = 0.0;
  for (std::size_t k = 0; k < forest.bodies.size; ++k) {
    const LaneBody& body = forest.bodies.begin[k];
    const Lanes* const twist = numbers(moves.twists[k].of);
    if (body.parent < 0) widest = max(widest, norm_squared(upper(twist)));
    for (std::uint32_t t = body.first_turn; t < body.first_turn + body.turns; ++t) {
      const Lanes angle = lanes_of(moves.angles[t]);
      widest = max(widest, angle * angle);
    }
    if (body.first == body.last) continue;
    furthest = max(furthest, norm_squared(velocity(twist, x[body.first])));
    furthest = max(furthest, norm_squared(velocity(twist, x[body.last - 1])));
  }
  const Lanes most = lanes_of(bound);
  Lanes share = select(furthest > most * most, most / sqrt(furthest), Lanes(1.0));
  const Lanes by_turn = min(share, Lanes(largest_turn) / sqrt(widest));
  share = select(widest > Lanes(largest_turn * largest_turn), by_turn, share);
  return value_of(share);
}

PLIANT_LANE_INLINE LaneVec3 moved(const LaneMotion& motion, const LaneVec3& x) {
  const LaneVec3 &rx = *vectors(&motion.rx), &ry = *vectors(&motion.ry), &rz = *vectors(&motion.rz),
                 &shift = *vectors(&motion.shift);
  return {dot(rx, x) + shift.x, dot(ry, x) + shift.y, dot(rz, x) + shift.z};
}

PLIANT_LANE_INLINE void set_motion(const LaneForest& forest, const LaneBody& body,
                                   const Lanes* twist, const LaneValue* angles,
                                   const Lanes& half_share, const Lanes& share, const LaneVec3* x,
                                   const LaneMotion* motions, LaneMotion& out) {
  LaneVec3 h{0.0, 0.0, 0.0};
  if (body.parent < 0) h = half_share * upper(twist);
  for (std::uint32_t t = body.first_turn; t < body.first_turn + body.turns; ++t)
    h += (half_share * lanes_of(angles[t])) * upper(numbers(forest.turns[t].s.of));
  const LaneVec3 g = (Lanes(2.0) / (Lanes(1.0) + norm_squared(h))) * h;
  const Lanes one = 1.0;
  const LaneVec3 rx{one - (h.y * g.y + h.z * g.z), h.x * g.y - g.z, h.x * g.z + g.y};
  const LaneVec3 ry{h.x * g.y + g.z, one - (h.x * g.x + h.z * g.z), h.y * g.z - g.x};
  const LaneVec3 rz{h.x * g.z - g.y, h.y * g.z + g.x, one - (h.x * g.x + h.y * g.y)};
  if (body.parent < 0) {
    *vectors(&out.rx) = rx, *vectors(&out.ry) = ry, *vectors(&out.rz) = rz;
    *vectors(&out.shift) = share * lower(twist);
    return;
  }
  const LaneMotion& carried = motions[body.parent];
  const LaneVec3 through = x[body.a];
  const LaneVec3 turned{dot(rx, through), dot(ry, through), dot(rz, through)};
  const auto row = [&](const LaneVec3& a) { return a.x * rx + a.y * ry + a.z * rz; };
  *vectors(&out.rx) = row(*vectors(&carried.rx));
  *vectors(&out.ry) = row(*vectors(&carried.ry));
  *vectors(&out.rz) = row(*vectors(&carried.rz));
  *vectors(&out.shift) = moved(carried, through - turned);
}

void move_bodies(const LaneForest& forest, LaneMoves moves, const LaneValue& of_step,
                 LaneMotion* room, LaneVector* places) {
  LaneVec3* const x = vectors(places);
  const Lanes share = lanes_of(of_step), half_share = Lanes(0.5) * share;
  for (std::size_t k = 0; k < forest.bodies.size; ++k)
    set_motion(forest, forest.bodies.begin[k], numbers(moves.twists[k].of), moves.angles,
               half_share, share, x, room, room[k]);
  for (std::size_t k = 0; k < forest.bodies.size; ++k)
    for (std::uint32_t at = forest.bodies.begin[k].first; at < forest.bodies.begin[k].last; ++at)
      x[at] = moved(room[k], x[at]);
}

constexpr LaneBodyKernels body_kernels = {.gather = gather_bodies,
                                          .go_inward = go_inward,
                                          .push_inward = push_inward,
                                          .go_outward = go_outward,
                                          .product = product,
                                          .apply_matrix = apply_matrix,
                                          .resist = resist,
                                          .add_scaled = add_scaled,
                                          .add_to_scaled = add_to_scaled,
                                          .copy = copy_lanes,
                                          .share_of = share_of,
                                          .move = move_bodies};

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
