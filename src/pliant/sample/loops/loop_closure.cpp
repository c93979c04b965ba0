// SPDX-License-Identifier: MIT
#include "pliant/sample/loops/loop_closure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/dense_solve.hpp"

namespace pliant {
namespace {

constexpr int most_steps = 60;
constexpr double largest_step = 0.6;  // radians
constexpr double turn_length = 3.0;   // Angstrom: turns of the end count as moves of that radius
constexpr double near_gap = 0.3;      // Angstrom: from here on nothing is wished
constexpr double closed_gap = 1e-12;  // Angstrom
constexpr double damping = 1e-3;      // of the mean diagonal, far from closed

struct EndMove {
  Vec3 shift, turn;
};

EndMove move_of(const RigidMotion& motion, Vec3 end) {
  const AxisAngle turn = axis_angle(motion.rotation);
  return {motion(end) - end, turn_length * turn.angle * turn.axis};
}

std::array<double, 6> six(Vec3 a, Vec3 b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }

}  // namespace

std::span<const RigidMotion> LoopClosure::motions(std::span<const double> turns) {
  motions_.resize(axes_.size());
  RigidMotion so_far;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    so_far = so_far.after(rotation_by(axes_[k].direction, turns[k]), axes_[k].origin);
    motions_[k] = so_far;
  }
  return motions_;
}

double LoopClosure::gap() const {
  const EndMove off = move_of(motions_.back(), end_);
  return std::sqrt(norm_squared(off.shift) + norm_squared(off.turn));
}

void LoopClosure::find_columns() {
  columns_.resize(6 * axes_.size());
  const Vec3 end = motions_.back()(end_);
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    // Its own turn leaves an axis where it is.
    const Vec3 axis = motions_[k].rotation(axes_[k].direction);
    const auto column = six(cross(axis, end - motions_[k](axes_[k].origin)), turn_length * axis);
    std::ranges::copy(column, columns_.begin() + static_cast<std::ptrdiff_t>(6 * k));
  }
}

/// The least change beyond what is wished that closes the gap: wishes + J^T (J J^T)^-1 (-gap - J
/// wishes).
bool LoopClosure::step(std::span<double> turns, std::span<const double> wishes) {
  find_columns();
  const EndMove off = move_of(motions_.back(), end_);
  const auto gaps = six(off.shift, off.turn);
  std::vector<double> right(6), matrix(36, 0.0);
  for (std::size_t r = 0; r < 6; ++r) right[r] = -gaps[r];
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const double* column = &columns_[6 * k];
    for (std::size_t r = 0; r < 6; ++r) {
      right[r] -= column[r] * wishes[k];
      for (std::size_t c = 0; c <= r; ++c) matrix[6 * r + c] += column[r] * column[c];
    }
  }
  double trace = 0.0;
  for (std::size_t r = 0; r < 6; ++r) trace += matrix[7 * r] / 6.0;
  const double share = gap() > near_gap ? damping : 1e-14;
  for (std::size_t r = 0; r < 6; ++r) matrix[7 * r] += share * trace;
  if (!solve_positive(matrix, right, 1e-13)) return false;
  std::vector<double> change(wishes.begin(), wishes.end());
  double most = 0.0;
  for (std::size_t k = 0; k < change.size(); ++k) {
    for (std::size_t r = 0; r < 6; ++r) change[k] += columns_[6 * k + r] * right[r];
    most = std::max(most, std::abs(change[k]));
  }
  const double part = most > largest_step ? largest_step / most : 1.0;
  for (std::size_t k = 0; k < change.size(); ++k) turns[k] += part * change[k];
  return std::isfinite(most);
}

bool LoopClosure::close(std::span<double> turns, const LoopWishes& wishes) {
  std::vector<double> wished(turns.size());
  motions(turns);
  for (int k = 0; k < most_steps; ++k) {
    std::ranges::fill(wished, 0.0);
    if (gap() > near_gap) wishes(turns, wished);
    if (!step(turns, wished)) return false;
    motions(turns);
    if (gap() < closed_gap) return true;
  }
  return false;
}

}  // namespace pliant
