// SPDX-License-Identifier: MIT
// The kernels of lane_bodies.hpp; a part of lane_level.cpp. What is not said here is said in
// ArticulatedPass and ArticulatedStep, operation by operation.
#pragma once

#include "pliant/resolve/lanes/lane_bodies.hpp"
#include "pliant/resolve/lanes/lane_memory_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

constexpr double least_inertia = 1e-6;  // as body_kernels.cpp has it

PLIANT_LANE_INLINE const Lanes* numbers(const LaneValue* x) {
  return reinterpret_cast<const Lanes*>(x);
}
PLIANT_LANE_INLINE LaneValue value_of(const Lanes& x) {
  LaneValue value;
  __builtin_memcpy(&value, &x, sizeof value);
  return value;
}
PLIANT_LANE_INLINE Lanes lanes_of(const LaneValue& x) { return *numbers(&x); }

PLIANT_LANE_INLINE LaneVec3 cross(const LaneVec3& a, const LaneVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PLIANT_LANE_INLINE Lanes sixfold(const Lanes* a, const Lanes* b) {
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}
PLIANT_LANE_INLINE void add_scaled6(const Lanes& factor, const Lanes* x, Lanes* y) {
  for (int k = 0; k < 6; ++k) y[k] += factor * x[k];
}
PLIANT_LANE_INLINE LaneVec3 upper(const Lanes* twist) { return {twist[0], twist[1], twist[2]}; }
PLIANT_LANE_INLINE LaneVec3 lower(const Lanes* twist) { return {twist[3], twist[4], twist[5]}; }
PLIANT_LANE_INLINE LaneVec3 velocity(const Lanes* twist, const LaneVec3& x) {
  return lower(twist) + cross(upper(twist), x);
}
PLIANT_LANE_INLINE void set_twist(const LaneVec3& up, const LaneVec3& low, Lanes* twist) {
  twist[0] = up.x, twist[1] = up.y, twist[2] = up.z;
  twist[3] = low.x, twist[4] = low.y, twist[5] = low.z;
}

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

PLIANT_LANE_INLINE void multiply(const Lanes* m, const Lanes* s, Lanes* out) {
  out[0] =
      ((m[0] * s[0] + m[1] * s[1]) + (m[3] * s[2] + m[6] * s[3])) + (m[10] * s[4] + m[15] * s[5]);
  out[1] =
      ((m[1] * s[0] + m[2] * s[1]) + (m[4] * s[2] + m[7] * s[3])) + (m[11] * s[4] + m[16] * s[5]);
  out[2] =
      ((m[3] * s[0] + m[4] * s[1]) + (m[5] * s[2] + m[8] * s[3])) + (m[12] * s[4] + m[17] * s[5]);
  out[3] =
      ((m[6] * s[0] + m[7] * s[1]) + (m[8] * s[2] + m[9] * s[3])) + (m[13] * s[4] + m[18] * s[5]);
  out[4] = ((m[10] * s[0] + m[11] * s[1]) + (m[12] * s[2] + m[13] * s[3])) +
           (m[14] * s[4] + m[19] * s[5]);
  out[5] = ((m[15] * s[0] + m[16] * s[1]) + (m[17] * s[2] + m[18] * s[3])) +
           (m[19] * s[4] + m[20] * s[5]);
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

constexpr int entry_of(int i, int j) { return i * (i + 1) / 2 + j; }

/// L D L^T of six by six.
PLIANT_LANE_INLINE void solve_root(const Lanes* inertia, const Lanes* force, double square_unit,
                                   Lanes* v) {
  Lanes m[21];
  for (int k = 0; k < 21; ++k) m[k] = inertia[k];
  for (int j = 0; j < 6; ++j) {
    Lanes& pivot = m[entry_of(j, j)];
    pivot += j < 3 ? least_inertia * square_unit : least_inertia;
    for (int k = 0; k < j; ++k) pivot -= m[entry_of(j, k)] * m[entry_of(j, k)] * m[entry_of(k, k)];
    for (int i = j + 1; i < 6; ++i) {
      Lanes sum = m[entry_of(i, j)];
      for (int k = 0; k < j; ++k) sum -= m[entry_of(i, k)] * m[entry_of(j, k)] * m[entry_of(k, k)];
      m[entry_of(i, j)] = sum / pivot;
    }
  }
  for (int i = 0; i < 6; ++i) v[i] = force[i];
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < i; ++k) v[i] -= m[entry_of(i, k)] * v[k];
  for (int i = 0; i < 6; ++i) v[i] = v[i] / m[entry_of(i, i)];
  for (int i = 6; i-- > 0;)
    for (int k = i + 1; k < 6; ++k) v[i] -= m[entry_of(k, i)] * v[k];
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

void add_scaled(const LaneValue& factor, const LaneValue* x, std::size_t count, LaneValue* y) {
  const Lanes by = lanes_of(factor);
  for (std::size_t k = 0; k < count; ++k) *numbers(&y[k]) += by * lanes_of(x[k]);
}

void add_to_scaled(const LaneValue* x, const LaneValue& factor, std::size_t count, LaneValue* y) {
  const Lanes by = lanes_of(factor);
  for (std::size_t k = 0; k < count; ++k) *numbers(&y[k]) = lanes_of(x[k]) + by * lanes_of(y[k]);
}

void copy_lanes(LaneMask lanes, const LaneValue* x, std::size_t count, LaneValue* y) {
  const Mask mask = Mask::of(lanes);
  for (std::size_t k = 0; k < count; ++k)
    *numbers(&y[k]) = select(mask, lanes_of(x[k]), lanes_of(y[k]));
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
