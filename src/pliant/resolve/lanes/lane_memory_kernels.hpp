// SPDX-License-Identifier: MIT
// Moves positions of walkers into lanes and back; a part of lane_level.cpp.
#pragma once

#include "pliant/resolve/lanes/lane_kernels.hpp"
#include "pliant/resolve/lanes/lanes.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

PLIANT_LANE_INLINE LaneVec3* vectors(LaneVector* x) { return reinterpret_cast<LaneVec3*>(x); }
PLIANT_LANE_INLINE const LaneVec3* vectors(const LaneVector* x) {
  return reinterpret_cast<const LaneVec3*>(x);
}
PLIANT_LANE_INLINE Lanes* numbers(LaneValue* x) { return reinterpret_cast<Lanes*>(x); }
PLIANT_LANE_INLINE Doubles load(const double* from) {
  Doubles row;
  __builtin_memcpy(&row, from, sizeof row);
  return row;
}
PLIANT_LANE_INLINE void store(const Doubles& row, double* to) {
  __builtin_memcpy(to, &row, sizeof row);
}

/// Transposes a matrix of doubles as wide as a register, given by rows.
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

/// Prefetches so many doubles ahead of a write: processors do not foresee eight rows by themselves,
/// and writes wait for distant memory (a fifth of a whole resolve).
constexpr std::size_t written_ahead = 64;

void scatter(const LaneValue* from, std::size_t count, double* const* rows) {
  const Lanes* const in = reinterpret_cast<const Lanes*>(from);
  std::size_t i = 0;
  for (; i + width <= count; i += width)
    for (int piece = 0; piece < pieces; ++piece) {
      Doubles block[width];
      for (int k = 0; k < width; ++k) block[k] = in[i + k].v[piece];
      transpose(block);
      for (int k = 0; k < width; ++k)
        if (double* const row = rows[piece * width + k]) {
          store(block[k], row + i);
          __builtin_prefetch(row + i + written_ahead, 1);
        }
    }
  for (; i < count; ++i)
    for (int lane = 0; lane < 8; ++lane)
      if (rows[lane] != nullptr) rows[lane][i] = in[i].get(lane);
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
