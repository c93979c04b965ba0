// SPDX-License-Identifier: MIT
#include "steps/twin.hpp"

#include <functional>
#include <memory>
#include <utility>

namespace pliant::play {
namespace {

RunOptions with_technique(RunOptions options, const Technique& technique) {
  options.technique = technique;
  return options;
}

}  // namespace

Twin::Twin(const Framework& framework, const State& state, const RunOptions& options,
           const Technique& technique, std::shared_ptr<StepClock> clock)
    : framework_(framework),
      technique_(technique),
      clock_(std::move(clock)),
      walk_(framework, state, with_technique(options, technique)),
      residuals_(std::in_place, framework) {}

void Twin::take(const MadeStep& step) {
  if (step.options != last_.options) walk_.set(with_technique(*step.options, technique_));
  if (step.pinned != last_.pinned) walk_.pin(*step.pinned);
  if (step.longest_step != last_.longest_step) walk_.hold_back(step.longest_step);
  if (step.edited != last_.edited) {
    walk_.put(walk_.state(), step.edited);
    residuals_.emplace(step.edited ? step.edited->framework : framework_);
  }
  last_ = {step.options, step.pinned, step.edited, {}, Act::pull, step.longest_step};
}

StepReport Twin::step(const MadeStep& step, const std::function<void(const RepairedBar&)>* on_bar) {
  take(step);
  const auto make = [&] {
    return make_step(walk_, *clock_, [&] {
      return step.act == Act::pull ? walk_.pull(step.forces) : walk_.wander(step.forces);
    });
  };
  return on_bar ? make_watched(walk_, *on_bar, make) : make();
}

}  // namespace pliant::play
