// SPDX-License-Identifier: MIT
#include "pliant/resolve/local/local_solver.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double leg = 1.0;         // Angstrom: largest distance between targets
constexpr double bound = 1.5;       // Angstrom: largest displacement of a body in a step
constexpr double most_legs = 1e3;
constexpr int most_pulls = 3;
constexpr double settled = 0.05;    // share of the first step's displacement
constexpr double widest_closed = 1e-13;  // Angstrom
constexpr int most_closings = 12;

}  // namespace

LocalSolver::LocalSolver(const Framework& framework, double unit)
    : planner_(framework),
      plan_(&planner_.plan({})),
      working_(*plan_),
      step_(*plan_, working_, unit),
      unit_(unit) {}

LocalResult LocalSolver::resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                                 std::span<const Joint> joints) {
  begin(start, target, joints);
  pull();
  LocalResult result;
  result.is_closed = close();
  result.visits = visits_;
  return result;
}

void LocalSolver::begin(std::span<const Vec3> start, std::span<const Vec3> target,
                        std::span<const Joint> joints) {
  planner_.plan(joints);
  working_.fit();
  step_.fit();
  visits_ = 0;
  origin_ = start[joints[0]];
  way_ = 0.0;
  const auto joint_at = plan_->joint_at();
  start_.resize(joint_at.size());
  push_.resize(joint_at.size());
  for (std::size_t k = 0; k < joint_at.size(); ++k) {
    start_[k] = start[joint_at[k]] - origin_;
    push_[k] = target[joint_at[k]] - start[joint_at[k]];
    way_ = std::max(way_, norm_squared(push_[k]));
  }
  way_ = std::sqrt(way_);
  pulls_.clear();
  for (Joint joint : joints) pulls_.push_back({plan_->place_of(joint), {}, weight_ - 1.0});
  x_ = start_;
  target_.resize(x_.size());
}

void LocalSolver::pull() {
  const double legs = std::clamp(std::ceil(way_ / (leg * unit_)), 1.0, most_legs);
  for (int k = 1; k < int(legs) + most_pulls; ++k) {
    const double share = std::min(1.0, k / legs);
    for (std::size_t at = 0; at < x_.size(); ++at) target_[at] = start_[at] + share * push_[at];
    for (PlacePull& pull : pulls_) pull.way = target_[pull.at] - x_[pull.at];
    if (step({target_, {}, {}, bound * unit_, 0, pulls_}) <= settled * way_ && share == 1.0) return;
  }
}

bool LocalSolver::close() {
  for (int k = 0; k < most_closings && widest_gap() > widest_closed * unit_; ++k)
    step({{}, {}, {}, bound * unit_, 0, {}});
  return widest_gap() <= 10.0 * widest_closed * unit_;
}

double LocalSolver::step(const StepRequest& request) {
  visits_ += static_cast<std::int64_t>(plan_->bodies().size());
  return step_.step(x_, request);
}

double LocalSolver::widest_gap() const {
  double widest = 0.0;
  for (const LoopCut& cut : plan_->cuts())
    widest = std::max(widest, norm_squared(x_[cut.copy] - x_[cut.joint]));
  return std::sqrt(widest);
}

}  // namespace pliant
