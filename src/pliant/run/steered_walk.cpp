// SPDX-License-Identifier: MIT
#include "pliant/run/steered_walk.hpp"

#include <utility>

#include "pliant/base/error.hpp"
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
  renew(options);
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
void SteeredWalk::renew(RunOptions options) {
  replace(made(framework(), options, pushing_));
  options_ = std::move(options);
}

/// The same with what is held; nothing has changed where it throws.
void SteeredWalk::hold(std::shared_ptr<const EditedFramework> edited,
                       std::span<const Joint> pinned) {
  const Framework& plain = edited ? edited->framework : framework_;
  std::shared_ptr<const Framework> held;
  if (!pinned.empty()) held = std::make_shared<const Framework>(plain.with_pinned(pinned));
  std::vector<Joint> joints(pinned.begin(), pinned.end());
  replace(made(held ? *held : plain, options_, pushing_));
  edited_ = std::move(edited);
  held_ = std::move(held);
  pinned_ = std::move(joints);
}

void SteeredWalk::replace(std::unique_ptr<Motion> motion) {
  if (motion_) add(done_, motion_->summary());
  motion_ = std::move(motion);
}

std::unique_ptr<SteeredWalk> SteeredWalk::branch() const {
  RunOptions options = options_;
  options.resolve.on_bar = {};
  auto other = std::make_unique<SteeredWalk>(framework_, state_, options);
  if (edited_ || !pinned_.empty()) other->hold(edited_, pinned_);
  return other;
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
  renew(options_);
}

void SteeredWalk::set(const RunOptions& options) {
  RunOptions wanted = options;
  wanted.resolve.on_bar = options_.resolve.on_bar;
  renew(std::move(wanted));
}

void SteeredWalk::pin(std::span<const Joint> joints) { hold(edited_, joints); }

void SteeredWalk::edit(std::span<const FrameworkEdit> edits) {
  if (edits.empty()) return;
  if (!state_.limits_off.empty())
    throw OptionError("edit: some contacts are switched off, which edits do not keep");
  std::vector<FrameworkEdit> all = edited_ ? edited_->edits : std::vector<FrameworkEdit>();
  all.insert(all.end(), edits.begin(), edits.end());
  hold(std::make_shared<const EditedFramework>(
           pliant::edited(framework_, std::move(all), state_.positions)),
       pinned_);
}

void SteeredWalk::watch(std::function<void(const RepairedBar&)> on_bar) {
  RunOptions wanted = options_;
  wanted.resolve.on_bar = std::move(on_bar);
  renew(std::move(wanted));
}

void SteeredWalk::look_at_push(std::function<void(std::span<const Vec3>)> look) {
  look_ = std::move(look);
}

void SteeredWalk::put(State state) {
  replace(nullptr);
  state_ = std::move(state);
}

void SteeredWalk::put(State state, std::shared_ptr<const EditedFramework> edited) {
  put(std::move(state));
  if (edited != edited_) hold(std::move(edited), pinned_);
}

}  // namespace pliant
