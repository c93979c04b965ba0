// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/anderson.hpp"

#include <cmath>

namespace pliant {
namespace {

double scalar_product(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

void subtract(std::span<const Vec3> a, std::span<const Vec3> b, std::vector<Vec3>& out) {
  out.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] - b[i];
}

/// Raises the diagonal of the normal equations, and the least pivot that is more than rounding.
constexpr double ridge = 1e-6, least_pivot = 1e-14;
/// Rounding errors of g come out multiplied by the sum of |gamma|.
constexpr double most_gamma = 200.0;

}  // namespace

void AndersonMixing::reserve(std::size_t count) {
  last_f_.reserve(count);
  last_g_.reserve(count);
  for (std::size_t c = 0; c < most_columns; ++c) {
    df_[c].reserve(count);
    dg_[c].reserve(count);
  }
}

bool AndersonMixing::mix(std::span<Vec3> f, std::span<const Vec3> g) {
  if (has_last_) add_column(f, g);
  remember(f, g);
  Column gamma{};
  if (columns_ == 0) return false;
  if (!solve(f, gamma)) {
    restart();
    return false;
  }
  for (std::size_t i = 0; i < f.size(); ++i) {
    Vec3 next = g[i];
    for (std::size_t c = 0; c < columns_; ++c) next -= gamma[c] * dg_[c][i];
    f[i] = next;
  }
  return true;
}

void AndersonMixing::remember(std::span<const Vec3> f, std::span<const Vec3> g) {
  last_f_.assign(f.begin(), f.end());
  last_g_.assign(g.begin(), g.end());
  has_last_ = true;
}

/// The oldest column makes room for the newest.
void AndersonMixing::add_column(std::span<const Vec3> f, std::span<const Vec3> g) {
  const std::size_t c = next_column_;
  subtract(f, last_f_, df_[c]);
  subtract(g, last_g_, dg_[c]);
  next_column_ = (c + 1) % most_columns;
  if (columns_ < most_columns) ++columns_;
  for (std::size_t other = 0; other < columns_; ++other)
    gram_[c][other] = gram_[other][c] = scalar_product(df_[c], df_[other]);
}

/// Least squares by Cholesky's factors of the normal equations; false if the columns depend on each
/// other, or anything is not finite.
bool AndersonMixing::solve(std::span<const Vec3> f, Column& gamma) const {
  std::array<Column, most_columns> lower{};
  for (std::size_t i = 0; i < columns_; ++i) {
    double right = scalar_product(df_[i], f);
    for (std::size_t j = 0; j < i; ++j) {
      double sum = gram_[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      lower[i][j] = sum / lower[j][j];
    }
    double pivot = gram_[i][i] * (1.0 + ridge);
    for (std::size_t k = 0; k < i; ++k) {
      pivot -= lower[i][k] * lower[i][k];
      right -= lower[i][k] * gamma[k];
    }
    if (!(pivot > least_pivot * gram_[i][i])) return false;
    lower[i][i] = std::sqrt(pivot);
    gamma[i] = right / lower[i][i];
  }
  double sum = 0.0;
  for (std::size_t i = columns_; i-- > 0;) {
    for (std::size_t k = i + 1; k < columns_; ++k) gamma[i] -= lower[k][i] * gamma[k];
    gamma[i] /= lower[i][i];
    sum += std::abs(gamma[i]);
  }
  return sum <= most_gamma;  // false also when it is not a number
}

}  // namespace pliant
