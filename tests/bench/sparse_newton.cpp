// SPDX-License-Identifier: MIT
#include "bench/sparse_newton.hpp"

#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>

namespace pliant::bench {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

void add_direction(Entries& entries, int column, Joint joint, Vec3 direction) {
  const double parts[] = {direction.x, direction.y, direction.z};
  for (int axis = 0; axis < 3; ++axis)
    entries.emplace_back(3 * static_cast<int>(joint) + axis, column, parts[axis]);
}

/// (3N, B): a bar's motion of the joints, of length 1, in each column.
Eigen::SparseMatrix<double> directions(const Framework& framework, std::span<const Vec3> x) {
  Entries entries;
  int column = 0;
  for (const Bar bar : framework.bars()) {
    const Vec3 along = x[bar.b] - x[bar.a];
    const Vec3 half = (1.0 / std::sqrt(2.0 * dot(along, along))) * along;
    add_direction(entries, column, bar.a, -1.0 * half);
    add_direction(entries, column, bar.b, half);
    ++column;
  }
  Eigen::SparseMatrix<double> found(3 * static_cast<int>(x.size()), column);
  found.setFromTriplets(entries.begin(), entries.end());
  found.makeCompressed();
  return found;
}

}  // namespace

std::vector<BarIndex> independent_bars(const Framework& framework, std::span<const Vec3> positions,
                                       double least_sine) {
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors;
  factors.setPivotThreshold(least_sine);
  factors.compute(directions(framework, positions));
  const auto order = factors.colsPermutation().indices();
  std::vector<BarIndex> kept;
  for (Eigen::Index k = 0; k < factors.rank(); ++k) kept.push_back(static_cast<BarIndex>(order[k]));
  std::sort(kept.begin(), kept.end());
  return kept;
}

SparseNewton::SparseNewton(const Framework& framework, std::vector<BarIndex> bars,
                           NewtonMatrix kind)
    : framework_(framework),
      bars_(std::move(bars)),
      kind_(kind),
      now_(bars_.size()),
      before_(bars_.size()) {
  make_pattern();
  errors_.resize(matrix_.rows());
  kind == NewtonMatrix::symmetric ? symmetric_factors_.analyzePattern(matrix_)
                                  : factors_.analyzePattern(matrix_);
}

/// Entry (k, l) for each two bars that share a joint: its inverse mass, negative where one bar
/// begins there and the other ends.
void SparseNewton::make_pattern() {
  std::vector<int> place(framework_.bar_count(), -1);
  for (std::size_t k = 0; k < bars_.size(); ++k) place[bars_[k]] = static_cast<int>(k);
  Entries entries;
  for (const BarIndex index : bars_) {
    const Bar bar = framework_.bars()[index];
    for (const Joint joint : {bar.a, bar.b}) {
      const double weight = framework_.inverse_masses()[joint];
      for (const Incidence& other : framework_.neighbours(joint)) {
        if (place[other.bar] < 0) continue;
        const bool alike = (framework_.bars()[other.bar].a == joint) == (bar.a == joint);
        entries.emplace_back(place[other.bar], place[index], alike ? weight : -weight);
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(bars_.size());
  matrix_.resize(size, size);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
  weights_.assign(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros());
}

Vec3 SparseNewton::along(std::span<const Vec3> positions, std::size_t k) const {
  const Bar bar = framework_.bars()[bars_[k]];
  return positions[bar.b] - positions[bar.a];
}

double SparseNewton::error(std::span<const Vec3> positions) const {
  double worst = 0.0;
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const Vec3 s = along(positions, k);
    const double rest = framework_.rest_lengths()[bars_[k]];
    worst = std::fmax(worst, std::abs(std::sqrt(dot(s, s)) - rest) / rest);
  }
  return worst;
}

int SparseNewton::resolve(std::span<Vec3> positions, std::span<const Vec3> whole, double tolerance,
                          int most) {
  for (std::size_t k = 0; k < bars_.size(); ++k) before_[k] = along(whole, k);
  if (kind_ == NewtonMatrix::symmetric) {
    fill(before_);
    symmetric_factors_.factorize(matrix_);
    if (symmetric_factors_.info() != Eigen::Success) return -1;
  }
  for (int done = 0; done <= most; ++done) {
    const double worst = error(positions);
    if (worst <= tolerance) return done;
    if (!std::isfinite(worst) || done == most || !step(positions)) return -1;
  }
  return -1;
}

void SparseNewton::measure_errors(std::span<const Vec3> positions) {
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    now_[k] = along(positions, k);
    const double rest = framework_.rest_lengths()[bars_[k]];
    errors_[static_cast<Eigen::Index>(k)] = 0.5 * (dot(now_[k], now_[k]) - rest * rest);
  }
}

/// The matrix J(directions) M^-1 J(r)^T.
void SparseNewton::fill(std::span<const Vec3> directions) {
  const int* first = matrix_.outerIndexPtr();
  for (std::size_t l = 0; l < bars_.size(); ++l)
    for (int entry = first[l]; entry < first[l + 1]; ++entry) {
      const auto k = static_cast<std::size_t>(matrix_.innerIndexPtr()[entry]);
      matrix_.valuePtr()[entry] =
          weights_[static_cast<std::size_t>(entry)] * dot(directions[k], before_[l]);
    }
}

bool SparseNewton::solve() {
  if (kind_ == NewtonMatrix::symmetric) {
    multipliers_ = symmetric_factors_.solve(errors_);
    return true;
  }
  fill(now_);
  factors_.factorize(matrix_);
  if (factors_.info() != Eigen::Success) return false;
  multipliers_ = factors_.solve(errors_);
  return true;
}

bool SparseNewton::step(std::span<Vec3> positions) {
  measure_errors(positions);
  if (!solve()) return false;
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const Bar bar = framework_.bars()[bars_[k]];
    const Vec3 push = multipliers_[static_cast<Eigen::Index>(k)] * before_[k];
    positions[bar.a] += framework_.inverse_masses()[bar.a] * push;
    positions[bar.b] -= framework_.inverse_masses()[bar.b] * push;
  }
  return true;
}

}  // namespace pliant::bench
