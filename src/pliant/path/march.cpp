// SPDX-License-Identifier: MIT
#include "pliant/path/march.hpp"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

constexpr double least_share = 0.05;  // of the way that steps were asked to go, if that is less
constexpr double rounding = 1e-6;     // nearer to a goal than this there is no way to go, Angstrom
constexpr double least_guided = 0.1;  // share of a step to be gained towards a goal on the way

}  // namespace

Way Way::first(std::size_t count) const {
  const auto end = static_cast<std::ptrdiff_t>(count);
  return {{places.begin(), places.begin() + end}, {left.begin(), left.begin() + end}, {}, turned};
}

Patience::Patience(double step, double begun)
    : least_(std::min(least_gain, least_share * double(path_patience) * step)), seen_{begun} {}

bool Patience::is_over(double left) {
  seen_.push_back(left);
  if (seen_.size() <= path_patience) return left < rounding;
  return seen_[seen_.size() - 1 - path_patience] - left < least_;
}

March::March(PathWalker& walker, Way& way, std::vector<std::vector<Vec3>> goals, double step)
    : walker_(walker), way_(way), goals_(std::move(goals)), step_(step) {
  aim(0);
}

bool March::advance() {
  while (!is_last() && (apart_ <= path_near || is_full())) aim(goal_ + 1);
  return is_last() ? arrive() : pass();
}

void March::aim(std::size_t goal) {
  goal_ = goal;
  apart_ = walker_.apart(goals_[goal]);
  if (is_last()) patience_.emplace(step_, apart_);
}

bool March::pass() {
  const StepEnd end = walker_.whole_step(goals_[goal_], step_);
  if (end == StepEnd::stopped) return true;
  if (end == StepEnd::not_whole) {
    aim(goal_ + 1);
    return true;
  }
  const double before = std::exchange(apart_, walker_.apart(goals_[goal_]));
  way_.add(walker_.now(), walker_.apart(goals_.back()));
  if (before - apart_ < least_guided * step_) aim(goal_ + 1);
  return true;
}

bool March::arrive() {
  if (apart_ <= rounding) return false;
  if (is_full()) return end("ended after " + std::to_string(most_path_steps) + " steps");
  const StepEnd stepped = walker_.whole_step(goals_[goal_], step_);
  if (stepped == StepEnd::stopped) return true;
  if (stepped == StepEnd::not_whole)
    return end("the last step could not be made whole, and is left out");
  apart_ = walker_.apart(goals_[goal_]);
  way_.add(walker_.now(), apart_);
  return !patience_->is_over(apart_);
}

bool March::end(const std::string& why) {
  way_.notes.push_back(why);
  return false;
}

}  // namespace pliant
