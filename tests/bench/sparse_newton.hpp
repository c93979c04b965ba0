// SPDX-License-Identifier: MIT
// The exact peer with bars for angles: Newton's method on the equations of SHAKE, each step by a
// sparse LU factorization of Eigen, as in ILVES (Lopez-Villellas et al., "ILVES: accurate and
// efficient bond length and angle constraints in molecular dynamics", 2025). Nothing of the
// library's own solvers is used.
//
//     g_k(x) = (|s_k|^2 - L_k^2) / 2 = 0,   s_k = x_b - x_a
//     A mu = g(x),   A = J(x) M^-1 J(r)^T,   x <- x - M^-1 J(r)^T mu
//
// with r the positions before the push. A is sparse and unsymmetric; where it has entries does not
// change, so that the order of elimination is found once. ILVES has linear solvers of its own and
// threads, which this has not. The cheaper variant, a quasi-Newton method, puts J(r) for J(x): the
// matrix is then symmetric, and factorized once a push, at the price of more steps.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant::bench {

/// Bars without which no other bar is determined to first order: columns of the rigidity matrix
/// that a rank-revealing sparse QR factorization keeps. A bar is left out if its direction lies
/// within `least_sine` of what the others span: six distances in a CX4 of which the tenth follows,
/// one in each planar group. Ascending.
std::vector<BarIndex> independent_bars(const Framework& framework, std::span<const Vec3> positions,
                                       double least_sine);

/// Factorized in each step, or once.
enum class NewtonMatrix : std::uint8_t { unsymmetric, symmetric };

/// Repairs again and again the bars that it was given.
class SparseNewton {
 public:
  /// The framework must outlive it.
  SparseNewton(const Framework& framework, std::vector<BarIndex> bars,
               NewtonMatrix kind = NewtonMatrix::unsymmetric);

  /// Steps until each of its bars is within the relative tolerance; -1 if that is not so after
  /// `most` steps, or a matrix is singular. `whole` (N) are the positions before the push.
  int resolve(std::span<Vec3> positions, std::span<const Vec3> whole, double tolerance,
              int most = 50);

  const std::vector<BarIndex>& bars() const { return bars_; }
  /// Largest relative error of its bars.
  double error(std::span<const Vec3> positions) const;
  std::size_t entries() const { return static_cast<std::size_t>(matrix_.nonZeros()); }

 private:
  void make_pattern();
  bool step(std::span<Vec3> positions);
  void measure_errors(std::span<const Vec3> positions);
  void fill(std::span<const Vec3> directions);
  bool solve();
  Vec3 along(std::span<const Vec3> positions, std::size_t k) const;

  const Framework& framework_;
  std::vector<BarIndex> bars_;
  NewtonMatrix kind_;
  std::vector<double> weights_;  ///< of each entry: what s_k . r_l is multiplied by, 1/u
  std::vector<Vec3> now_, before_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd errors_, multipliers_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> symmetric_factors_;
};

}  // namespace pliant::bench
