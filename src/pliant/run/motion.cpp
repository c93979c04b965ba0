// SPDX-License-Identifier: MIT
#include "pliant/run/motion.hpp"

#include "pliant/perturb/pushers.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/run/walk.hpp"

namespace pliant {

/// The walker and what resolves it.
struct Motion::WalkPlan {
  std::unique_ptr<State> own;  ///< null if the state lives elsewhere
  Walk walk;
  Resolver resolver;

  WalkPlan(const Framework& framework, std::unique_ptr<State> mine, State& state,
           const MotionOptions& options, std::uint64_t walker)
      : own(std::move(mine)),
        walk(framework, state, options, walker),
        resolver(framework, options.technique, options.resolve) {
    warn_if_doubtful(options.technique, framework, options.log);
  }
};

void check(const MotionOptions& options) {
  check(options.technique);
  check(options.resolve);
  for (const std::string& name : options.push) find_pusher(name);
  check(options.perturb);
}

Motion::Motion(const Framework& framework, State state, const MotionOptions& options,
               std::uint64_t walker) {
  check(options);
  auto own = std::make_unique<State>(std::move(state));
  State& kept = *own;
  plan_ = std::make_unique<WalkPlan>(framework, std::move(own), kept, options, walker);
}

Motion::Motion(const Framework& framework, std::reference_wrapper<State> state,
               const MotionOptions& options, std::uint64_t walker) {
  check(options);
  plan_ = std::make_unique<WalkPlan>(framework, nullptr, state.get(), options, walker);
}

Motion::~Motion() = default;
Motion::Motion(Motion&&) noexcept = default;

void Motion::add(std::shared_ptr<Pusher> pusher) { plan_->walk.add(std::move(pusher)); }

Frame Motion::start() {
  plan_->walk.start(plan_->resolver);
  return frame();
}

Frame Motion::step() {
  advance();
  return frame();
}

bool Motion::advance() {
  Walk& walk = plan_->walk;
  try {
    walk.push();
    return walk.finish(walk.resolve(plan_->resolver));
  } catch (...) {
    walk.take_back_push();
    throw;
  }
}

Frame Motion::frame() { return plan_->walk.frame(); }
const ResolveSummary& Motion::resolved() const { return plan_->walk.resolved(); }
const Push& Motion::pushed() const { return plan_->walk.pushed(); }
const State& Motion::state() const { return plan_->walk.state(); }
State& Motion::change_state() { return plan_->walk.change_state(); }
const RunSummary& Motion::summary() const { return plan_->walk.summary(); }
bool Motion::is_over() const { return plan_->walk.is_over(); }
void Motion::stop() { plan_->walk.stop(); }

}  // namespace pliant
