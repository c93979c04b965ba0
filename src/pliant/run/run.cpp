// SPDX-License-Identifier: MIT
#include "pliant/run/run.hpp"

#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/value_text.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/resolve/walkers.hpp"
#include "pliant/run/run_fields.hpp"
#include "pliant/run/showing.hpp"
#include "pliant/run/together.hpp"

namespace pliant {

void check(const RunOptions& options) {
  check_fields(options);
  check(options.technique);
  if (!std::isfinite(double(options.steps) * options.perturb_options.timestep))
    throw OptionError("timestep = " + value_text(options.perturb_options.timestep) +
                      ": the time of " + std::to_string(options.steps) + " steps is not finite");
}

MotionOptions motion_of(const RunOptions& options, std::int64_t start, const Log& log) {
  std::vector<std::string> push = pushers_of(options.guide);
  if (replayed_steps(options) > 0) push = {"replay"};
  if (push.empty()) push = {options.perturb};
  return {options.technique,    options.resolve, push,          options.perturb_options,
          options.replay,       start,           options.guide, log,
          options.replay_counts};
}

RunSummary run(const Framework& framework, State& state, const RunOptions& options,
               const std::vector<Observer>& observers) {
  check(options);
  const std::int64_t began = options.began.value_or(state.step);
  Motion motion(framework, std::ref(state), motion_of(options, began, options.log),
                options.resolve.walker);
  for (const std::shared_ptr<Pusher>& hand : options.hands) motion.add(hand);
  Showing showing(observers, options.on_push, options.onlooker, options, began);
  if (!options.began) showing.show_start(motion, motion.start());
  while (!showing.is_over(motion))
    if (motion.advance()) showing.tell(motion);
  return showing.with_observers(motion.summary());
}

std::vector<RunSummary> run_walkers(const Framework& framework, std::span<WalkerRun> walkers,
                                    const RunOptions& options) {
  check(options);
  WalkerResolver resolver(framework, options.technique, options.resolve, options.lanes);
  return Together(framework, resolver, walkers, options).run();
}

}  // namespace pliant
