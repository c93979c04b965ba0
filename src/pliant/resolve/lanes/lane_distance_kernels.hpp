// SPDX-License-Identifier: MIT
// Steps of a few points towards given distances in lanes, as approach() of
// conformers/rings/distance_fit.cpp does them; a part of lane_level.cpp.
#pragma once

#include "pliant/resolve/lanes/lane_bar_kernels.hpp"

namespace pliant::PLIANT_LANE_LEVEL {
namespace {

/// Rows that are reduced side by side, in registers.
constexpr std::size_t rows_together = pieces > 2 ? 2 : 4;

template <std::size_t rows>
PLIANT_LANE_INLINE void reduce(Lanes* a, std::size_t n, std::size_t i, std::size_t j,
                               const Lanes& inverse) {
  Lanes sums[rows];
  for (std::size_t r = 0; r < rows; ++r) sums[r] = a[(i + r) * n + j];
  for (std::size_t k = 0; k < j; ++k) {
    const Lanes pivot = a[j * n + k];
    for (std::size_t r = 0; r < rows; ++r) sums[r] -= a[(i + r) * n + k] * pivot;
  }
  for (std::size_t r = 0; r < rows; ++r) a[(i + r) * n + j] = sums[r] * inverse;
}

/// As solve_positive() of base/math/dense_solve.hpp, without a least pivot.
Mask solve_positive(std::size_t n, Lanes* a, Lanes* b) {
  Mask solved = Mask::all(true);
  for (std::size_t j = 0; j < n; ++j) {
    const Lanes least = Lanes(0.0) * a[j * n + j];  // not a number for what is not finite
    reduce<1>(a, n, j, j, 1.0);
    solved &= a[j * n + j] > least;
    const Lanes inverse = Lanes(1.0) / sqrt(a[j * n + j]);
    a[j * n + j] *= inverse;
    std::size_t i = j + 1;
    for (; i + rows_together <= n; i += rows_together) reduce<rows_together>(a, n, i, j, inverse);
    for (; i < n; ++i) reduce<1>(a, n, i, j, inverse);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i * n + k] * b[k];
    b[i] = b[i] / a[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k * n + i] * b[k];
    b[i] = b[i] / a[i * n + i];
  }
  return solved;
}

/// Squared distances, their errors and half of their gradients, and room for equations.
struct DistanceEquations {
  LaneList<LaneDistance> wanted;
  std::size_t points;
  double damped;
  Lanes *product, *off, *right;
  LaneVec3* apart;

  void set(const LaneVec3* x) {
    for (std::size_t a = 0; a < wanted.size; ++a) {
      const LaneDistance& at = wanted.begin[a];
      apart[a] = x[at.i] - x[at.j];
      off[a] = norm_squared(apart[a]) - Lanes(at.square);
    }
  }

  void raise_diagonal(std::size_t n, const Lanes& largest) {
    for (std::size_t k = 0; k < n; ++k) product[k * n + k] += Lanes(damped) * largest;
  }

  Mask step_by_distances(LaneVec3* x) {
    const std::size_t n = wanted.size;
    Lanes largest = 0.0;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        const LaneDistance &one = wanted.begin[a], &other = wanted.begin[b];
        const int shared =
            (one.i == other.i) + (one.j == other.j) - (one.i == other.j) - (one.j == other.i);
        product[a * n + b] =
            shared == 0 ? Lanes(0.0) : Lanes(4.0 * shared) * dot(apart[a], apart[b]);
        if (shared != 0) largest = max(largest, product[a * n + b]);
      }
    raise_diagonal(n, largest);
    const Mask solved = solve_positive(n, product, off);
    for (std::size_t a = 0; a < n; ++a) {
      const LaneVec3 along = (Lanes(2.0) * off[a]) * apart[a];
      x[wanted.begin[a].i] -= along;
      x[wanted.begin[a].j] += along;
    }
    return solved;
  }

  Mask step_by_places(LaneVec3* x) {
    const std::size_t n = 3 * points;
    for (std::size_t k = 0; k < n * n; ++k) product[k] = 0.0;
    for (std::size_t k = 0; k < n; ++k) right[k] = 0.0;
    Lanes largest = 0.0;
    for (std::size_t a = 0; a < wanted.size; ++a) {
      largest = max(largest, Lanes(8.0) * norm_squared(apart[a]));
      add(a, n);
    }
    raise_diagonal(n, largest);
    const Mask solved = solve_positive(n, product, right);
    for (std::size_t k = 0; k < points; ++k)
      x[k] -= LaneVec3{right[3 * k], right[3 * k + 1], right[3 * k + 2]};
    return solved;
  }

  void add(std::size_t a, std::size_t n) {
    const LaneDistance& ends = wanted.begin[a];
    const LaneVec3& half = apart[a];
    const Lanes at[3] = {Lanes(2.0) * half.x, Lanes(2.0) * half.y, Lanes(2.0) * half.z};
    const std::size_t low = 3 * (ends.i < ends.j ? ends.i : ends.j);
    const std::size_t high = 3 * (ends.i < ends.j ? ends.j : ends.i);
    for (std::size_t p = 0; p < 3; ++p) {
      right[3 * ends.i + p] += at[p] * off[a];
      right[3 * ends.j + p] -= at[p] * off[a];
      for (std::size_t q = 0; q < 3; ++q) {
        if (q <= p) product[(low + p) * n + low + q] += at[p] * at[q];
        if (q <= p) product[(high + p) * n + high + q] += at[p] * at[q];
        product[(high + p) * n + low + q] -= at[p] * at[q];
      }
    }
  }
};

LaneMask approach(LaneList<LaneDistance> wanted, std::size_t points, double damped, int steps,
                  LaneValue* room, LaneVector* positions) {
  const std::size_t count = wanted.size, n = count > 3 * points ? 3 * points : count;
  Lanes* const at = numbers(room);
  DistanceEquations equations{wanted,
                              points,
                              damped,
                              at,
                              at + n * n,
                              at + n * n + count,
                              vectors(reinterpret_cast<LaneVector*>(room + n * n + count + n))};
  LaneVec3* const x = vectors(positions);
  Mask solved = Mask::all(true);
  for (int step = 0; step < steps && solved.bits() != 0; ++step) {
    equations.set(x);
    solved &= count > 3 * points ? equations.step_by_places(x) : equations.step_by_distances(x);
  }
  return solved.bits();
}

}  // namespace
}  // namespace pliant::PLIANT_LANE_LEVEL
