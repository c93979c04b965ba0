// SPDX-License-Identifier: MIT
// The loops of Newton's method on bars, shared by one walker and eight walkers in lanes: Real is
// double or Lanes, Vec is Vec3 or LaneVec3. One source gives the same arithmetic, bit by bit.
//
// Arrays of Real and Vec begin with the part's first bar, joint or entry; indices of BarPattern
// count from the first part.
#pragma once

#include "pliant/base/vec3.hpp"
#include "pliant/resolve/equations/bar_pattern.hpp"

namespace pliant {

/// Number of steps without gain after which iterations end: of BarNewton, of shake, of
/// NearestPoint.
inline constexpr int newton_bad_steps = 3, shake_bad_steps = 5, nearest_bad_steps = 3;
/// Relative error at which the conjugate gradients of NearestPoint end.
inline constexpr double inner_accuracy = 1e-2;
inline constexpr int most_inner_iterations = 40;

inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

/// The lower triangle of J W J^T with each diagonal entry raised by `damping` times itself.
template <class Real, class Vec>
inline void fill_gram(const BarPattern& part, const Vec* directions, double damping, Real* diagonal,
                      Real* lower) {
  const std::uint32_t first = part.bars.begin, first_entry = part.ldl.column_begin[first];
  for (std::uint32_t k = first; k < part.bars.end; ++k) {
    const Vec& d = directions[k - first];
    diagonal[k - first] = Real(1.0 + damping) * (Real(part.diagonal_weights[k]) * norm_squared(d));
    for (std::uint32_t p = part.ldl.column_begin[k]; p < part.ldl.column_begin[k + 1]; ++p)
      lower[p - first_entry] =
          Real(part.couplings[p]) * dot(d, directions[part.ldl.rows[p] - first]);
  }
}

/// A pivot below this share of the diagonal entry is rounding: the column depends on earlier ones.
inline constexpr double vanishing_pivot = 1e-11;

/// Factors in place. Calls `drop` with whether each pivot vanishes; such columns are left out.
template <class Real, class Drop>
inline void factor_columns(const LdlPattern& ldl, std::uint32_t first, std::uint32_t end,
                           Real* diagonal, Real* inverse, Real* lower, Drop drop) {
  const std::uint32_t first_entry = ldl.column_begin[first];
  // The diagonal before elimination, to recognize vanishing pivots.
  for (std::uint32_t k = 0; k < end - first; ++k) inverse[k] = Real(vanishing_pivot) * diagonal[k];
  for (std::uint32_t k = first; k < end; ++k) {
    const Real pivot = diagonal[k - first];
    const auto stays = pivot > inverse[k - first];
    drop(!stays);
    const Real inverted = select(stays, Real(1.0) / pivot, Real(0.0));
    inverse[k - first] = inverted;
    const std::uint32_t* target = ldl.targets + ldl.target_begin[k];
    const std::uint32_t entries_end = ldl.column_begin[k + 1];
    for (std::uint32_t p = ldl.column_begin[k]; p < entries_end; ++p) {
      const Real entry = lower[p - first_entry], scaled = entry * inverted;
      diagonal[ldl.rows[p] - first] -= entry * scaled;
      for (std::uint32_t q = p + 1; q < entries_end; ++q)
        lower[*target++ - first_entry] -= lower[q - first_entry] * scaled;
      lower[p - first_entry] = scaled;
    }
  }
}

/// Solves in place with the factors of factor_columns.
template <class Real>
inline void solve_columns(const LdlPattern& ldl, std::uint32_t first, std::uint32_t end,
                          const Real* inverse, const Real* lower, Real* b) {
  const std::uint32_t first_entry = ldl.column_begin[first];
  for (std::uint32_t k = first; k < end; ++k) {
    const Real value = b[k - first];
    for (std::uint32_t p = ldl.column_begin[k]; p < ldl.column_begin[k + 1]; ++p)
      b[ldl.rows[p] - first] -= lower[p - first_entry] * value;
  }
  for (std::uint32_t k = end; k-- > first;) {
    Real value = b[k - first] * inverse[k - first];
    // A column that was left out has no entries to be divided: its factor is 0.
    for (std::uint32_t p = ldl.column_begin[k]; p < ldl.column_begin[k + 1]; ++p)
      value -= lower[p - first_entry] * b[ldl.rows[p] - first];
    b[k - first] = value;
  }
}

/// v -= W J^T lambda: from bars to joints.
template <class Real, class Vec>
inline void pull_joints(const BarPattern& part, const Vec* directions, const Real* lambda, Vec* v) {
  const std::uint32_t first = part.bars.begin, first_joint = part.joints.begin;
  for (std::uint32_t k = first; k < part.bars.end; ++k) {
    const Vec pull = lambda[k - first] * directions[k - first];
    const EquationEnds ends = part.ends[k];
    v[ends.a - first_joint] += Real(part.weights[ends.a]) * pull;
    v[ends.b - first_joint] -= Real(part.weights[ends.b]) * pull;
  }
}

/// out = J v: from joints to bars.
template <class Real, class Vec>
inline void stretch_bars(const BarPattern& part, const Vec* directions, const Vec* v, Real* out) {
  const std::uint32_t first = part.bars.begin, first_joint = part.joints.begin;
  for (std::uint32_t k = first; k < part.bars.end; ++k) {
    const EquationEnds ends = part.ends[k];
    out[k - first] = dot(directions[k - first], v[ends.b - first_joint] - v[ends.a - first_joint]);
  }
}

/// out += W (sum of lambda_k times the Laplacian of bar k) v, for joints.
template <class Real, class Vec>
inline void bend_joints(const BarPattern& part, const Real* lambda, const Vec* v, Vec* out) {
  const std::uint32_t first = part.bars.begin, first_joint = part.joints.begin;
  for (std::uint32_t k = first; k < part.bars.end; ++k) {
    const EquationEnds ends = part.ends[k];
    const Vec pull = lambda[k - first] * (v[ends.b - first_joint] - v[ends.a - first_joint]);
    out[ends.a - first_joint] -= Real(part.weights[ends.a]) * pull;
    out[ends.b - first_joint] += Real(part.weights[ends.b]) * pull;
  }
}

/// Sum of m_j v_j w_j over `count` joints.
template <class Real, class Vec>
inline Real weighted_product(const double* masses, const Vec* v, const Vec* w,
                             std::uint32_t count) {
  Vec sum{Real(0.0), Real(0.0), Real(0.0)};  // by coordinate: three additions at a time
  for (std::uint32_t j = 0; j < count; ++j)
    sum += Real(masses[j]) * Vec{v[j].x * w[j].x, v[j].y * w[j].y, v[j].z * w[j].z};
  return sum.x + sum.y + sum.z;
}

/// A move below this share of the coordinates is rounding.
inline constexpr double rounding_of_coordinates = 16.0 * 0x1p-52;

/// The square of the largest move, in units of the error allowed for the bars of its joint.
template <class Real, class Vec>
inline Real asked_squared(const double* allowed, const Vec* x, const Vec* move,
                          std::uint32_t count) {
  constexpr double part = rounding_of_coordinates * rounding_of_coordinates;
  Real worst(0.0);
  for (std::uint32_t j = 0; j < count; ++j) {
    const Real floor = Real(part) * norm_squared(x[j]);
    const Real asked = norm_squared(move[j]) / (Real(allowed[j] * allowed[j]) + floor);
    worst = select(worst < asked, asked, worst);
  }
  return worst;
}

}  // namespace pliant
