// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_equations.hpp"

#include "pliant/base/math/dense_solve.hpp"

namespace pliant {

void LoopEquations::begin(std::span<const Vec3> x, double damping) {
  const std::size_t n = hinges_.size();
  x_ = x;
  matrix_.assign(n * n, 0.0);
  right_.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    matrix_[k * n + k] = damping;
    const Vec3 along = x[hinges_[k].b] - x[hinges_[k].a];
    axes_[k] = (1.0 / norm(along)) * along;
  }
}

void LoopEquations::add_to_row(Slot place, Vec3 gradient) {
  for (std::size_t k = 0; k < row_.size(); ++k)
    if (hinges_[k].turns(place))
      row_[k] += dot(axes_[k], cross(x_[place] - x_[hinges_[k].b], gradient));
}

void LoopEquations::end_row(double off, double weight) {
  const std::size_t n = row_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (row_[i] == 0.0) continue;
    const double scaled = weight * row_[i];
    right_[i] -= scaled * off;
    for (std::size_t j = 0; j <= i; ++j) matrix_[i * n + j] += scaled * row_[j];
  }
}

void LoopEquations::add_damping(double share) {
  const std::size_t n = right_.size();
  double trace = 0.0;
  for (std::size_t k = 0; k < n; ++k) trace += matrix_[k * n + k];
  for (std::size_t k = 0; k < n; ++k) matrix_[k * n + k] += share * trace / double(n);
}

std::span<const double> LoopEquations::solve() {
  if (!solve_positive(matrix_, right_, 0.0)) return {};
  return right_;
}

}  // namespace pliant
