// SPDX-License-Identifier: MIT
#include "pliant/run/steered_walk.hpp"

#include <utility>

#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

/// Moves nothing: shows what the pushers before it have moved.
class Look final : public Pusher {
 public:
  explicit Look(const std::function<void(std::span<const Vec3>)>& look) : look_(look) {}

  bool push(const PushCall&, State& state, Push&) override {
    if (look_) look_(state.positions);
    return true;
  }

 private:
  const std::function<void(std::span<const Vec3>)>& look_;
};

}  // namespace

SteeredWalk::SteeredWalk(const Framework& framework, State state, const RunOptions& options)
    : framework_(framework),
      state_(std::move(state)),
      options_(options),
      hand_(std::make_shared<Steering>()) {
  renew(nullptr, options);
}

std::unique_ptr<Motion> SteeredWalk::made(const Framework& framework, const RunOptions& options,
                                          Pushing by) {
  check_fields(options);
  MotionOptions wanted;
  wanted.technique = options.technique;
  wanted.resolve = options.resolve;
  wanted.perturb = options.perturb_options;
  wanted.log = options.log;
  wanted.push.clear();
  if (by == Pushing::at_random) wanted.push.push_back(options.perturb);
  auto motion =
      std::make_unique<Motion>(framework, std::ref(state_), wanted, options.resolve.walker);
  motion->add(hand_);
  motion->add(std::make_shared<Look>(look_));
  return motion;
}

/// A Motion goes on from a state as another one would have: so each change may make a new one.
void SteeredWalk::renew(std::shared_ptr<const Framework> held, RunOptions options) {
  replace(made(held ? *held : framework_, options, pushing_));
  held_ = std::move(held);
  options_ = std::move(options);
}

void SteeredWalk::replace(std::unique_ptr<Motion> motion) {
  if (motion_) add(done_, motion_->summary());
  motion_ = std::move(motion);
}

const ResolveSummary& SteeredWalk::resolved() const {
  static const ResolveSummary none;
  return motion_ ? motion_->resolved() : none;
}

RunSummary SteeredWalk::summary() const {
  RunSummary all = done_;
  if (motion_) add(all, motion_->summary());
  return all;
}

Motion& SteeredWalk::motion(Pushing by) {
  if (!motion_ || by != pushing_) {
    replace(made(framework(), options_, by));
    pushing_ = by;
  }
  return *motion_;
}

Frame SteeredWalk::start() { return motion(pushing_).start(); }

Frame SteeredWalk::frame() { return motion(pushing_).frame(); }

Frame SteeredWalk::pull(std::span<const JointForce> forces) {
  Motion& walker = motion(Pushing::by_hand);
  hand_->pull(forces);
  return walker.step();
}

Frame SteeredWalk::wander(std::span<const JointForce> forces) {
  Motion& walker = motion(Pushing::at_random);
  hand_->pull(forces);
  return walker.step();
}

void SteeredWalk::hold_back(double longest_step) {
  hand_ = std::make_shared<Steering>(longest_step);
  renew(held_, options_);
}

void SteeredWalk::set(const RunOptions& options) {
  RunOptions wanted = options;
  wanted.resolve.on_bar = options_.resolve.on_bar;
  renew(held_, std::move(wanted));
}

void SteeredWalk::pin(std::span<const Joint> joints) {
  std::shared_ptr<const Framework> held;
  if (!joints.empty()) held = std::make_shared<const Framework>(framework_.with_pinned(joints));
  std::vector<Joint> pinned(joints.begin(), joints.end());
  renew(held, options_);
  pinned_ = std::move(pinned);
}

void SteeredWalk::watch(std::function<void(const RepairedBar&)> on_bar) {
  RunOptions wanted = options_;
  wanted.resolve.on_bar = std::move(on_bar);
  renew(held_, std::move(wanted));
}

void SteeredWalk::look_at_push(std::function<void(std::span<const Vec3>)> look) {
  look_ = std::move(look);
}

void SteeredWalk::put(State state) {
  replace(nullptr);
  state_ = std::move(state);
}

}  // namespace pliant
