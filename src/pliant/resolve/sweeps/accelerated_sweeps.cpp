// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/accelerated_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {

AcceleratedSweeps::AcceleratedSweeps(std::vector<Joint> joints, LimitSweep* limits)
    : joints_(std::move(joints)), limits_(limits) {
  for (std::vector<Vec3>* room : {&x_, &other_, &f_, &last_g_}) room->reserve(joints_.size());
  mixing_.reserve(joints_.size());
}

Joint AcceleratedSweeps::place(Joint joint) const {
  return static_cast<Joint>(std::lower_bound(joints_.begin(), joints_.end(), joint) -
                            joints_.begin());
}

void AcceleratedSweeps::add(PlannedBar visit) {
  visit.near = place(visit.near);
  visit.far = place(visit.far);
  plan_.add(visit);
}

void AcceleratedSweeps::begin(std::span<const Vec3> positions) {
  x_.resize(joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) x_[i] = positions[joints_[i]];
  plan_.begin();
  state_ = look();
  if (state_ != Look::broken) return;
  other_ = x_;
  mixing_.restart();
  path_ = 0.0;
  extrapolated_ = on_plain_track_ = false;
  stretch_ = left_ = first_stretch;
}

void AcceleratedSweeps::put_into(std::span<Vec3> positions) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) positions[joints_[i]] = x_[i];
}

void AcceleratedSweeps::sweep_once(const RandomKey& key) {
  plan_.sweep(x_, key);
  if (limits_ != nullptr) looked_at_limits_ = limits_->sweep(x_, key);
}

Look AcceleratedSweeps::look() {
  const Look bars = plan_.look(x_);
  return limits_ != nullptr && bars == Look::all_whole ? limits_->look(x_) : bars;
}

std::int64_t AcceleratedSweeps::sweep(const RandomKey& key) {
  if (left_-- == 0) change_track();
  if (on_plain_track_) {
    sweep_once(key);
    state_ = look();
  } else {
    accelerate(key);
  }
  return static_cast<std::int64_t>(plan_.size()) + looked_at_limits_;
}

void AcceleratedSweeps::change_track() {
  std::swap(x_, other_);
  on_plain_track_ = !on_plain_track_;
  if (!on_plain_track_) stretch_ *= 2;
  left_ = stretch_ - 1;
}

/// An extrapolation (f_, from x_) may double the way that the joints have come, not more.
void AcceleratedSweeps::go_no_further_than_the_path() {
  double squared = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) squared += norm_squared(f_[i] - x_[i]);
  const double length = std::sqrt(squared);
  if (length > path_) {
    for (std::size_t i = 0; i < x_.size(); ++i) f_[i] = x_[i] + (path_ / length) * (f_[i] - x_[i]);
  }
  path_ += std::min(length, path_);
}

void AcceleratedSweeps::accelerate(const RandomKey& key) {
  f_ = x_;
  sweep_once(key);
  double step = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    f_[i] = x_[i] - f_[i];
    step += norm_squared(f_[i]);
  }
  if (extrapolated_ && !(step <= 4.0 * last_step_)) {  // also when it is not a number
    x_ = last_g_;
    mixing_.restart();
    extrapolated_ = false;
    state_ = look();
    return;
  }
  state_ = look();
  if (state_ != Look::broken) return;
  last_g_ = x_;
  last_step_ = step;
  path_ += std::sqrt(step);
  extrapolated_ = mixing_.mix(f_, x_);
  if (!extrapolated_) return;
  go_no_further_than_the_path();
  std::swap(x_, f_);
  state_ = look();
  if (state_ == Look::not_finite) state_ = Look::broken;  // the next sweep takes it back
}

}  // namespace pliant
