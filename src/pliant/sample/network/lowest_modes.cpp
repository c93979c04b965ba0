// SPDX-License-Identifier: MIT
#include "pliant/sample/network/lowest_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/math/dense_cholesky.hpp"
#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace {

constexpr std::size_t largest_direct = 300;
constexpr std::size_t block_width = 8;
constexpr double least_share = 1e-9;  // of the largest diagonal entry: below, in the null space
constexpr double shift_share = 1e-10;
constexpr double least_residual = 1e-9;
/// Krylov vectors are looked at for the first time when there are so many: as many as the modes of
/// most molecules take. Each look costs as much as twenty of them.
constexpr std::size_t looked_at(std::size_t count) { return 4 * count + 7 * block_width; }
/// A vector that loses more than this in being set at right angles to others has nothing new.
constexpr double nothing_new = 1e-12;

double largest_diagonal(const DenseMatrix& a) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.rows(); ++k) largest = std::max(largest, a(k, k));
  return largest;
}

/// No eigenvalue is larger (Gershgorin).
double largest_row_sum(const DenseMatrix& a) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    double sum = 0.0;
    for (double value : a.row(i)) sum += std::abs(value);
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Lifts the directions of the null space to `height`.
void lift(DenseMatrix& a, const DenseMatrix& still, double height) {
  for (std::size_t z = 0; z < still.rows(); ++z)
    for (std::size_t i = 0; i < a.rows(); ++i)
      add_scaled(height * still(z, i), still.row(z), a.row(i));
}

EigenPairs keep_lowest(const EigenPairs& all, double least, double below, std::size_t count) {
  std::size_t first = 0;
  while (first < all.values.size() && !(all.values[first] > least)) ++first;
  std::size_t last = first;
  while (last < all.values.size() && last - first < count && all.values[last] < below) ++last;
  EigenPairs kept{
      {all.values.begin() + std::ptrdiff_t(first), all.values.begin() + std::ptrdiff_t(last)},
      DenseMatrix(last - first, all.vectors.columns())};
  for (std::size_t k = first; k < last; ++k) {
    const auto from = all.vectors.row(k);
    std::copy(from.begin(), from.end(), kept.vectors.row(k - first).begin());
    make_sign_canonical(kept.vectors.row(k - first));
  }
  return kept;
}

/// add_scaled(factor, y, x), then dot_product(z, x): the same numbers by one way through x.
double add_scaled_then_dot(double factor, std::span<const double> y, std::span<double> x,
                           std::span<const double> z) {
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  std::size_t k = 0;
  for (; k + 4 <= x.size(); k += 4)
    for (std::size_t lane = 0; lane < 4; ++lane) {
      x[k + lane] += factor * y[k + lane];
      sums[lane] += z[k + lane] * x[k + lane];
    }
  for (std::size_t lane = 0; k < x.size(); ++k, ++lane) {
    x[k] += factor * y[k];
    sums[lane] += z[k] * x[k];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// A space that grows by what the inverse of a matrix makes of its newest vectors.
class InverseKrylov {
 public:
  InverseKrylov(DenseMatrix a, std::size_t most)
      : n_(a.rows()), inverse_(std::move(a)), basis_(most + block_width, n_), images_(most, n_) {
    RandomSequence draws(RandomKey{0, Domain::amplitude, ~std::uint64_t{0}, 0, 0});
    for (std::size_t k = 0; k < block_width; ++k) {
      fill_normal(draws, basis_.row(size_));
      add_direction(size_);
    }
  }

  std::size_t size() const { return done_; }

  /// Multiplies the newest vectors by the inverse. False if they gave no new direction.
  bool grow() {
    const std::size_t first = done_, last = size_;
    if (first == last || last > images_.rows()) return false;
    EightVectors columns(n_);
    for (std::size_t k = first; k < last; ++k)
      for (std::size_t i = 0; i < n_; ++i) columns[i][k - first] = basis_(k, i);
    inverse_.solve(columns);
    for (std::size_t k = first; k < last; ++k)
      for (std::size_t i = 0; i < n_; ++i) images_(k, i) = columns[i][k - first];
    for (std::size_t k = first; k < last; ++k) {
      const auto from = images_.row(k);
      std::copy(from.begin(), from.end(), basis_.row(size_).begin());
      add_direction(size_);
    }
    done_ = last;
    return true;
  }

  /// Eigenpairs of the inverse within the space: values descending would be wanted, so they are of
  /// minus the inverse.
  EigenPairs within() const {
    DenseMatrix inner(done_, done_);
    for (std::size_t i = 0; i < done_; ++i)
      for (std::size_t j = i; j < done_; ++j)
        inner(i, j) = inner(j, i) = -dot_product(basis_.row(i), images_.row(j));
    return symmetric_eigen(std::move(inner));
  }

  /// What row k of `pairs` stands for, and how far it is from an eigenvector, as a share.
  double expand(const EigenPairs& pairs, std::size_t k, std::span<double> vector) const {
    std::vector<double> image(n_, 0.0);
    std::fill(vector.begin(), vector.end(), 0.0);
    for (std::size_t i = 0; i < done_; ++i) {
      add_scaled(pairs.vectors(k, i), basis_.row(i), vector);
      add_scaled(pairs.vectors(k, i), images_.row(i), image);
    }
    add_scaled(pairs.values[k], vector, image);
    return std::sqrt(dot_product(image, image)) / std::abs(pairs.values[k]);
  }

 private:
  /// Sets row k at right angles to those before, twice for the sake of rounding, and takes it in
  /// unless nothing is left.
  void add_direction(std::size_t k) {
    const auto x = basis_.row(k);
    const double before = std::sqrt(dot_product(x, x));
    for (int again = 0; again < 2 && k > 0; ++again) {
      double along = dot_product(basis_.row(0), x);
      for (std::size_t i = 0; i + 1 < k; ++i)
        along = add_scaled_then_dot(-along, basis_.row(i), x, basis_.row(i + 1));
      add_scaled(-along, basis_.row(k - 1), x);
    }
    const double after = std::sqrt(dot_product(x, x));
    if (!(after > nothing_new * before)) return;
    for (double& value : x) value *= 1.0 / after;
    size_ = k + 1;
  }

  std::size_t n_;
  DenseCholesky inverse_;
  DenseMatrix basis_, images_;
  std::size_t size_ = 0, done_ = 0;  ///< vectors in basis_; of these, with an image
};

EigenPairs by_inverse(DenseMatrix a, double height, std::size_t count) {
  const std::size_t n = a.rows();
  const double shift = shift_share * height;
  for (std::size_t k = 0; k < n; ++k) a(k, k) += shift;
  const std::size_t most = std::min(n, 10 * count + 10 * block_width);
  InverseKrylov space(std::move(a), most);
  EigenPairs found;
  for (std::size_t target = std::min(most, looked_at(count));; target += 10 * block_width) {
    while (space.size() < target && space.grow()) {
    }
    const EigenPairs inner = space.within();
    const std::size_t wanted = std::min(inner.values.size(), count + block_width);
    found = {std::vector<double>(wanted), DenseMatrix(wanted, n)};
    double worst = 0.0;
    for (std::size_t k = 0; k < wanted; ++k) {
      const double residual = space.expand(inner, k, found.vectors.row(k));
      if (k < count) worst = std::max(worst, residual);
      found.values[k] = -1.0 / inner.values[k] - shift;
    }
    if (worst < least_residual || space.size() < target || target >= most) return found;
  }
}

}  // namespace

EigenPairs lowest_modes(DenseMatrix a, const DenseMatrix& still, std::size_t count) {
  const double height = std::max(largest_diagonal(a), 1e-300);
  const double bound = std::max(largest_row_sum(a), 1e-300);
  lift(a, still, 2.0 * bound);  // out of the way, above all others
  const double least = least_share * height, below = 1.5 * bound;
  if (a.rows() > largest_direct)
    return keep_lowest(by_inverse(std::move(a), height, count), least, below, count);
  return keep_lowest(symmetric_eigen(std::move(a)), least, below, count);
}

}  // namespace pliant
