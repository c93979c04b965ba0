// SPDX-License-Identifier: MIT
#include "pliant/path/path_walker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/math/superposition.hpp"

namespace pliant {
namespace {

constexpr double tolerance = 1e-10;        // of bars, share of their length
constexpr std::int64_t most_sweeps = 300;  // a step that takes more is not whole
constexpr int most_halved = 3;             // times that a step which cannot be made whole is halved

MotionOptions motion_options(std::function<bool()> should_stop) {
  MotionOptions options;
  options.technique = {"froda", 0.5};
  options.resolve.tolerance.relative = tolerance;
  options.resolve.max_sweeps = most_sweeps;
  options.resolve.should_stop = std::move(should_stop);
  options.push = {};
  return options;
}

}  // namespace

/// Moves asked atoms towards their goals, and with them the residues that they are of.
class GoalPusher final : public Pusher {
 public:
  explicit GoalPusher(const PathSide& side) : side_(side) {
    std::uint32_t last = 0;
    for (std::uint32_t leader : side.leader) last = std::max(last, leader);
    counts_.resize(last + 1);
    for (std::uint32_t atom : side.asked) counts_[side.leader[atom]] += 1.0;
  }

  void ask(std::span<const Vec3> goal, double length, std::span<const Vec3> drift) {
    goal_.assign(goal.begin(), goal.end());
    drift_.assign(drift.begin(), drift.end());
    length_ = length;
  }

  bool push(const PushCall& call, State& state, Push& out) override {
    std::vector<Vec3> moves = ways(asked_of(side_, state.positions), goal_);
    const double apart = rms(moves);
    const double share = apart > 0.0 ? std::min(1.0, length_ / apart) : 0.0;
    for (Vec3& move : moves) move *= share;
    std::vector<Vec3> common = means(moves);
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const std::uint32_t atom = side_.asked[k];
      state.positions[atom] += moves[k] - common[side_.leader[atom]];
    }
    for (std::size_t k = 0; k < drift_.size(); ++k) common[k] += drift_[k];
    for (std::size_t atom = 0; atom < state.positions.size(); ++atom)
      state.positions[atom] += common[side_.leader[atom]];
    out.add_all(call.framework.joint_count() == 0 ? no_joint : 0);
    return true;
  }

 private:
  /// (R) mean move of the asked atoms of each residue.
  std::vector<Vec3> means(const std::vector<Vec3>& moves) const {
    std::vector<Vec3> sums(counts_.size());
    for (std::size_t k = 0; k < moves.size(); ++k) sums[side_.leader[side_.asked[k]]] += moves[k];
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] *= 1.0 / std::max(counts_[k], 1.0);
    return sums;
  }

  const PathSide& side_;
  std::vector<double> counts_;  ///< (R) asked atoms
  std::vector<Vec3> goal_, drift_;
  double length_ = 0.0;
};

PathWalker::PathWalker(const PathSide& side, std::function<bool()> should_stop)
    : side_(side),
      pusher_(std::make_shared<GoalPusher>(side)),
      motion_(side.model.framework, State(side.model.positions),
              motion_options(std::move(should_stop))) {
  motion_.add(pusher_);
  now_ = place_of(motion_.start());
}

SharedPlace PathWalker::place_of(const Frame& frame) {
  return std::make_shared<const PathPlace>(
      PathPlace{{frame.positions.begin(), frame.positions.end()},
                frame.sweeps,
                frame.projections,
                frame.max_residual,
                frame.rms_residual,
                frame.max_limit,
                frame.max_overlap});
}

StepEnd PathWalker::step(std::span<const Vec3> goal, double length, std::span<const Vec3> drift) {
  pusher_->ask(goal, length, drift);
  const Frame frame = motion_.step();
  if (frame.stop == Stop::converged) {
    now_ = place_of(frame);
    return StepEnd::whole;
  }
  put(now_);
  return frame.stop == Stop::stopped_by_caller ? StepEnd::stopped : StepEnd::not_whole;
}

StepEnd PathWalker::whole_step(std::span<const Vec3> goal, double length) {
  StepEnd end = step(goal, length);
  for (int halved = 0; halved < most_halved && end == StepEnd::not_whole; ++halved) {
    length *= 0.5;
    end = step(goal, length);
  }
  return end;
}

void PathWalker::put(SharedPlace place) {
  now_ = std::move(place);
  State& state = motion_.change_state();
  state.positions = state.previous = now_->positions;
}

std::vector<Vec3> PathWalker::asked() const { return asked_of(side_, now_->positions); }

double PathWalker::apart(std::span<const Vec3> goal) const { return rms(ways(asked(), goal)); }

std::vector<Vec3> ways(std::span<const Vec3> here, std::span<const Vec3> goal) {
  const RigidMotion onto = superposition(goal, here);
  std::vector<Vec3> moves;
  moves.reserve(here.size());
  for (std::size_t k = 0; k < here.size(); ++k) moves.push_back(onto(goal[k]) - here[k]);
  return moves;
}

double rms(std::span<const Vec3> moves) {
  double sum = 0.0;
  for (Vec3 move : moves) sum += norm_squared(move);
  return moves.empty() ? 0.0 : std::sqrt(sum / double(moves.size()));
}

std::vector<Vec3> asked_of(const PathSide& side, std::span<const Vec3> positions) {
  std::vector<Vec3> places;
  places.reserve(side.asked.size());
  for (std::uint32_t atom : side.asked) places.push_back(positions[atom]);
  return places;
}

}  // namespace pliant
