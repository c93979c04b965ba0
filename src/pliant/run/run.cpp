// SPDX-License-Identifier: MIT
#include "pliant/run/run.hpp"

#include <algorithm>
#include <optional>

#include "pliant/base/error.hpp"
#include "pliant/framework/check_positions.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/run/run_fields.hpp"
#include "pliant/run/walk.hpp"

namespace pliant {
namespace {

void check_replay(const Framework& framework, const RunOptions& options) {
  for (const JointForce& push : options.replay) {
    if (push.joint >= framework.joint_count())
      throw OptionError("replay: joint " + std::to_string(push.joint) + " of " +
                        std::to_string(framework.joint_count()) + " does not exist");
    if (!is_finite(push.force))
      throw OptionError("replay: the force on " + framework.label(push.joint) + " is not finite");
  }
}

void check_previous(const Framework& framework, const State& state) {
  if (state.previous.size() != framework.joint_count())
    throw InputError("framework: " + std::to_string(framework.joint_count()) + " joints but " +
                     std::to_string(state.previous.size()) + " previous positions");
  for (std::size_t i = 0; i < state.previous.size(); ++i)
    if (!is_finite(state.previous[i]))
      throw InputError("previous position of " + framework.label(static_cast<Joint>(i)) +
                       " is not finite");
}

void check_start(const Framework& framework, const State& state, const RunOptions& options,
                 const Log& log) {
  check_positions(framework, state.positions, options.resolve.tolerance, log);
  check_previous(framework, state);
}

/// Walkers in step with each other.
class Together {
 public:
  Together(const Framework& framework, std::span<WalkerRun> walkers, const RunOptions& options)
      : resolver_(framework, options.technique, options.resolve, options.lanes) {
    walks_.reserve(walkers.size());
    for (WalkerRun& walker : walkers)
      walks_.emplace_back(framework, walker, options, resolver_.alone());
  }

  std::vector<RunSummary> all() {
    for (Walk& walk : walks_) walk.begin();
    try {
      while (step()) continue;
    } catch (...) {
      for (Walk& walk : walks_) walk.take_back_push();
      throw;
    }
    std::vector<RunSummary> summaries;
    for (const Walk& walk : walks_) summaries.push_back(walk.summary());
    return summaries;
  }

 private:
  /// False if all walkers are done.
  bool step() {
    stepping_.clear();
    for (Walk& walk : walks_)
      if (!walk.is_over()) stepping_.push_back(&walk);
    for (Walk* walk : stepping_) walk->push();
    take_those_alike();
    if (alike_.size() > 1) resolve_alike();
    for (Walk* walk : stepping_) walk->finish(walk->resolve());
    return std::any_of(walks_.begin(), walks_.end(), [](const Walk& w) { return !w.is_over(); });
  }

  /// Moves those from stepping_ to alike_ that can be resolved at once: same step, same root.
  void take_those_alike() {
    alike_.clear();
    if (stepping_.size() < 2) return;
    root_ = stepping_.front()->whole_resolve_from();
    // Asked last: from the first time on the lanes' plans take memory.
    if (!root_ || resolver_.level().empty()) return;
    const std::int64_t step = stepping_.front()->step();
    const auto others =
        std::stable_partition(stepping_.begin(), stepping_.end(), [&](const Walk* walk) {
          return walk->step() != step || walk->whole_resolve_from() != root_;
        });
    alike_.assign(others, stepping_.end());
    if (alike_.size() > 1) stepping_.erase(others, stepping_.end());
  }

  void resolve_alike() {
    positions_.clear();
    for (Walk* walk : alike_)
      positions_.push_back({walk->number(), walk->positions(), walk->previous()});
    resolved_.resize(alike_.size());
    resolver_.resolve(
        positions_, resolved_, *root_, alike_.front()->step(),
        alike_.front()->shows_this_step() ? Measured::rms_residual : Measured::max_residual);
    for (std::size_t k = 0; k < alike_.size(); ++k) alike_[k]->finish_together(resolved_[k]);
  }

  WalkerResolver resolver_;
  std::vector<Walk> walks_;
  std::vector<Walk*> stepping_, alike_;
  std::optional<Joint> root_;
  std::vector<WalkerPositions> positions_;
  std::vector<ResolveSummary> resolved_;
};

}  // namespace

void check(const RunOptions& options) {
  check_fields(options);
  check(options.technique);
}

RunSummary run(const Framework& framework, State& state, const RunOptions& options,
               const std::vector<Observer>& observers) {
  WalkerRun walker{state, options.resolve.walker, observers, options.on_push, options.log};
  return run_walkers(framework, {&walker, 1}, options).front();
}

std::vector<RunSummary> run_walkers(const Framework& framework, std::span<WalkerRun> walkers,
                                    const RunOptions& options) {
  check(options);
  for (const WalkerRun& walker : walkers) check_start(framework, walker.state, options, walker.log);
  check_replay(framework, options);
  if (framework.joint_count() == 0) throw InputError("nothing to run: no joints");
  return Together(framework, walkers, options).all();
}

}  // namespace pliant
