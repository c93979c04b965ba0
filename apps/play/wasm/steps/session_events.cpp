// SPDX-License-Identifier: MIT
// What an event of a force file does to the session: one place for all kinds of events.
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/run/run_fields.hpp"
#include "session.hpp"

namespace pliant::play {

void Session::settle() {
  if (!unsettled_) return;
  const RunOptions wanted = *std::exchange(unsettled_, std::nullopt);
  set(wanted);
}

void Session::start_again() {
  if (!done_.empty()) throw OptionError("start: expected before the first step");
  walk_->put(State(document_.positions));
  walk_->start();
  start_by_ = options_;
}

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace

std::optional<StepReport> Session::apply(const ForceEvent& event) {
  if (const auto* one = std::get_if<SetOption>(&event.what)) {
    if (!unsettled_) unsettled_ = options();
    set_run_field(*unsettled_, one->name, one->value);
    return std::nullopt;
  }
  settle();
  std::optional<StepReport> made;
  std::visit(Overloaded{
                 [](const SetOption&) {},
                 [&](const PinJoints& pins) { pin(pins.joints); },
                 [&](const PullStep& step) { made = pull(step.forces); },
                 [&](const WanderSteps& steps) {
                   made = report(step_of(steps.forces, Act::wander),
                                 [&] { return walk_->wander(steps.forces); });
                 },
                 [&](const HoldBack& hold) {
                   walk_->hold_back(hold.longest_step);
                   longest_step_ = hold.longest_step;
                 },
                 [&](const StartWalk&) { start_again(); },
                 [&](const FrameworkEdit& one) { edit({one}); },
             },
             event.what);
  return made;
}

}  // namespace pliant::play
