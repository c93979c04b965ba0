// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/committed_walker.hpp"

#include <algorithm>
#include <utility>

namespace pliant {

std::optional<WalkerReached> CommittedWalker::reached() {
  std::optional<Committed> found = log_.committed(walker_);
  if (!found) return std::nullopt;
  log_.replay(walker_, [&](const Frame& frame) { kept_.add(frame); });
  committed_ = kept_.size();
  was_done_ = found->is_done;
  if (was_done_) found->state.step = run_.steps;
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
  if (is_shown_early(state)) kept_.remove_last();
  // A walker whose start was not shown yet begins again.
  if (!was_done_ && kept_.size() > 0) commit(state, is_done);
}

/// A walker that is stopped shows its last step, which it would not have shown.
bool CommittedWalker::is_shown_early(const State& state) const {
  const std::int64_t replayed = replayed_steps(run_);
  const std::int64_t last = replayed > 0 ? std::min(run_.steps, replayed) : run_.steps;
  const bool is_due = state.step % run_.every == 0 || state.step >= last ||
                      has_arrived(run_.guide, state.positions);
  return !is_due && kept_.size() > committed_ && kept_[kept_.size() - 1].step == state.step;
}

void CommittedWalker::commit(const State& state, bool is_done) {
  log_.commit(walker_, kept_, committed_, state, is_done);
  committed_ = kept_.size();
  clock_.restart();
}

}  // namespace pliant
