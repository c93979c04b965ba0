// SPDX-License-Identifier: MIT
#include "commands/committed_walker.hpp"

#include <utility>

namespace pliant::app {

std::optional<WalkerReached> CommittedWalker::reached(std::int64_t last_step) {
  std::optional<Committed> found = log_.committed(walker_);
  if (!found) return std::nullopt;
  log_.replay(walker_, [&](const Frame& frame) { kept_.add(frame); });
  committed_ = kept_.size();
  was_done_ = found->is_done;
  if (was_done_) found->state.step = last_step;
  return WalkerReached{std::move(found->state), 0};
}

bool CommittedWalker::wants(std::int64_t) {
  if (seen_) commit(*seen_, false);
  seen_.reset();
  return clock_.is_due();
}

void CommittedWalker::look(const Frame& frame) {
  State& state = seen_.emplace();
  state.step = frame.step;
  state.time = frame.time;
  state.positions.assign(frame.positions.begin(), frame.positions.end());
  state.previous.assign(frame.previous.begin(), frame.previous.end());
  state.limits_off.assign(frame.limits_off.begin(), frame.limits_off.end());
}

void CommittedWalker::end(const State& state, bool is_done) {
  // A walker whose start was not shown yet begins again.
  if (!was_done_ && kept_.size() > 0) commit(state, is_done);
}

void CommittedWalker::commit(const State& state, bool is_done) {
  log_.commit(walker_, kept_, committed_, state, is_done);
  committed_ = kept_.size();
  clock_.restart();
}

}  // namespace pliant::app
