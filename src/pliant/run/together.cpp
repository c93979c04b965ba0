// SPDX-License-Identifier: MIT
#include "pliant/run/together.hpp"

#include <algorithm>
#include <optional>

namespace pliant {
namespace {

/// Where the technique begins, if it has to look at every bar: those alike can be resolved at once.
std::optional<Joint> root_of_whole_resolve(const Walk& walk) {
  const Disturbed disturbed = walk.disturbed();
  if (!disturbed.all || !walk.is_finite_after_push()) return std::nullopt;
  return disturbed.root;
}

}  // namespace

Together::Together(const Framework& framework, WalkerResolver& resolver,
                   std::span<WalkerRun> walkers, const RunOptions& options)
    : resolver_(resolver) {
  walkers_.reserve(walkers.size());
  for (WalkerRun& walker : walkers) {
    const std::int64_t start = walker.began.value_or(walker.state.step);
    walkers_.push_back(
        {Walk(framework, walker.state, motion_of(options, start, walker.log), walker.number),
         Showing(walker.observers, walker.on_push, walker.onlooker, options, start),
         walker.began.has_value()});
    for (const std::shared_ptr<Pusher>& hand : walker.hands) walkers_.back().walk.add(hand);
  }
}

std::vector<RunSummary> Together::run() {
  for (Shown& walker : walkers_) {
    if (walker.goes_on) continue;
    walker.walk.start(resolver_.alone());
    walker.showing.show_start(walker.walk, walker.walk.frame());
  }
  try {
    while (step()) continue;
  } catch (...) {
    for (Shown& walker : walkers_) walker.walk.take_back_push();
    throw;
  }
  std::vector<RunSummary> summaries;
  for (const Shown& walker : walkers_)
    summaries.push_back(walker.showing.with_observers(walker.walk.summary()));
  return summaries;
}

/// False if all walkers are done.
bool Together::step() {
  push();
  part_alike();
  if (!alike_.empty()) resolve_alike();
  for (Shown* walker : alone_) finish(*walker, walker->walk.resolve(resolver_.alone()));
  return std::any_of(walkers_.begin(), walkers_.end(),
                     [](const Shown& walker) { return !walker.is_over(); });
}

void Together::push() {
  alone_.clear();
  for (Shown& walker : walkers_)
    if (!walker.is_over()) alone_.push_back(&walker);
  for (Shown* walker : alone_) walker->walk.push();
}

/// Moves those from alone_ to alike_ that can be resolved at once: same step, same root.
void Together::part_alike() {
  alike_.clear();
  if (alone_.size() < 2) return;
  const Walk& first = alone_.front()->walk;
  const std::optional<Joint> root = root_of_whole_resolve(first);
  // Asked last: from the first time on the lanes' plans take memory.
  if (!root || resolver_.level().empty()) return;
  const auto others = std::stable_partition(alone_.begin(), alone_.end(), [&](const Shown* walker) {
    return walker->walk.state().step != first.state().step ||
           root_of_whole_resolve(walker->walk) != root;
  });
  if (alone_.end() - others < 2) return;
  alike_.assign(others, alone_.end());
  alone_.erase(others, alone_.end());
}

void Together::resolve_alike() {
  positions_.clear();
  for (Shown* walker : alike_)
    positions_.push_back({walker->walk.number(), walker->walk.positions(),
                          walker->walk.state().previous, walker->walk.state().limits_off});
  resolved_.resize(alike_.size());
  const Shown& first = *alike_.front();
  const std::int64_t step = first.walk.state().step;
  resolver_.resolve(positions_, resolved_, first.walk.disturbed().root, step,
                    first.showing.is_due(step) ? Measured::rms_residual : Measured::max_residual);
  for (std::size_t k = 0; k < alike_.size(); ++k) finish(*alike_[k], resolved_[k]);
}

void Together::finish(Shown& walker, const ResolveSummary& resolved) {
  if (walker.walk.finish(resolved)) walker.showing.tell(walker.walk);
}

}  // namespace pliant
