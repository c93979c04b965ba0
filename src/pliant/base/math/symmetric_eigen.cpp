// SPDX-License-Identifier: MIT
#include "pliant/base/math/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pliant {
namespace {

/// More rotations than any eigenvalue of a finite matrix was ever seen to take.
constexpr int most_rotations = 60;

class TridiagonalForm {
 public:
  explicit TridiagonalForm(DenseMatrix& a) : a_(a), n_(a.rows()), p_(n_) {}

  std::vector<double> diagonal, beside;  ///< beside[k] joins k and k + 1

  /// Leaves reflections in the rows of the matrix, above its diagonal.
  void reduce() {
    diagonal.resize(n_);
    beside.assign(n_, 0.0);
    scale_.assign(n_, 0.0);
    for (std::size_t k = 0; k + 1 < n_; ++k) reflect(k);
    for (std::size_t k = 0; k < n_; ++k) diagonal[k] = a_(k, k);
  }

  /// The product of the reflections, transposed: rows are the new axes.
  DenseMatrix axes() {
    DenseMatrix q(n_, n_);
    for (std::size_t k = 0; k < n_; ++k) q(k, k) = 1.0;
    for (std::size_t k = n_; k-- > 0;) {
      if (scale_[k] == 0.0) continue;
      const auto v = a_.row(k).subspan(k + 1);
      for (std::size_t i = k + 1; i < n_; ++i) {
        const auto row = q.row(i).subspan(k + 1);
        add_scaled(-scale_[k] * dot_product(v, row), v, row);
      }
    }
    return q;
  }

 private:
  /// Clears row k beyond its second diagonal.
  void reflect(std::size_t k) {
    const auto x = a_.row(k).subspan(k + 1);
    const double length = std::sqrt(dot_product(x, x));
    const double kept = x[0] > 0.0 ? -length : length;
    beside[k] = kept;
    x[0] -= kept;
    const double square = dot_product(x, x);
    if (!(square > 0.0)) return;
    scale_[k] = 2.0 / square;
    turn_rest(k);
  }

  /// A - v w^T - w v^T of the rest, w = scale (A v - scale / 2 (v A v) v).
  void turn_rest(std::size_t k) {
    const auto v = a_.row(k).subspan(k + 1);
    const std::size_t m = v.size();
    std::fill(p_.begin(), p_.begin() + std::ptrdiff_t(m), 0.0);
    const std::span<double> p(p_.data(), m);
    for (std::size_t i = 0; i < m; ++i) add_scaled(v[i], a_.row(k + 1 + i).subspan(k + 1), p);
    for (double& value : p) value *= scale_[k];
    add_scaled(-0.5 * scale_[k] * dot_product(p, v), v, p);
    for (std::size_t i = 0; i < m; ++i) {
      const auto row = a_.row(k + 1 + i).subspan(k + 1);
      const double vi = v[i], pi = p[i];
      for (std::size_t j = 0; j < m; ++j) row[j] -= vi * p[j] + pi * v[j];
    }
  }

  DenseMatrix& a_;
  std::size_t n_;
  std::vector<double> p_, scale_;
};

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// One implicit QL step on diagonals l..m of a tridiagonal matrix; axes are turned along.
void ql_step(std::vector<double>& d, std::vector<double>& e, DenseMatrix& axes, std::size_t l,
             std::size_t m) {
  double g = (d[l + 1] - d[l]) / (2.0 * e[l]);
  const double root = length_of(g, 1.0);
  g = d[m] - d[l] + e[l] / (g + (g < 0.0 ? -root : root));
  double s = 1.0, c = 1.0, shifted = 0.0;
  for (std::size_t i = m; i-- > l;) {
    double f = s * e[i];
    const double b = c * e[i];
    const double r = length_of(f, g);
    e[i + 1] = r;
    if (r == 0.0) {
      d[i + 1] -= shifted;
      e[m] = 0.0;
      return;
    }
    s = f / r;
    c = g / r;
    g = d[i + 1] - shifted;
    const double t = (d[i] - g) * s + 2.0 * c * b;
    shifted = s * t;
    d[i + 1] = g + shifted;
    g = c * t - b;
    const auto low = axes.row(i), high = axes.row(i + 1);
    for (std::size_t k = 0; k < low.size(); ++k) {
      f = high[k];
      high[k] = s * low[k] + c * f;
      low[k] = c * low[k] - s * f;
    }
  }
  d[l] -= shifted;
  e[l] = g;
  e[m] = 0.0;
}

/// The first m from l on after which the matrix falls apart.
std::size_t end_of_block(const std::vector<double>& d, const std::vector<double>& e,
                         std::size_t l) {
  std::size_t m = l;
  for (; m + 1 < d.size(); ++m) {
    const double size = std::abs(d[m]) + std::abs(d[m + 1]);
    if (std::abs(e[m]) + size == size) break;
  }
  return m;
}

}  // namespace

EigenPairs symmetric_eigen(DenseMatrix a) {
  const std::size_t n = a.rows();
  TridiagonalForm form(a);
  form.reduce();
  DenseMatrix axes = form.axes();
  std::vector<double>&d = form.diagonal, &e = form.beside;
  for (std::size_t l = 0; l < n; ++l) {
    for (int turn = 0; turn < most_rotations; ++turn) {
      const std::size_t m = end_of_block(d, e, l);
      if (m == l) break;
      ql_step(d, e, axes, l, m);
    }
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return d[x] < d[y]; });
  EigenPairs out{std::vector<double>(n), DenseMatrix(n, n)};
  for (std::size_t k = 0; k < n; ++k) {
    out.values[k] = d[order[k]];
    const auto from = axes.row(order[k]);
    std::copy(from.begin(), from.end(), out.vectors.row(k).begin());
  }
  return out;
}

void make_sign_canonical(std::span<double> vector) {
  double largest = 0.0;
  for (double value : vector) largest = std::max(largest, std::abs(value));
  const auto first = std::find_if(vector.begin(), vector.end(), [&](double value) {
    return std::abs(value) >= (1.0 - 1e-6) * largest;
  });
  if (first == vector.end() || !(*first < 0.0)) return;
  for (double& value : vector) value = -value;
}

}  // namespace pliant
