// SPDX-License-Identifier: MIT
#include "pliant/perturb/push_chain.hpp"

#include <algorithm>

namespace pliant {

void PushChain::add(std::shared_ptr<Pusher> pusher) {
  RandomKey key{key_.seed, Domain::pusher, 0, 0, links_.size()};
  links_.push_back({std::move(pusher), links_.empty() ? key_.seed : RandomSequence(key).bits()});
  is_over_ = false;
}

void PushChain::push(State& state) {
  time_before_ = state.time;
  was_over_ = is_over_;
  push_.clear();
  past_.begin_step(state);
  try {
    push_all(state);
  } catch (...) {
    past_.take_back_step(state);
    throw;
  }
  drop_repeated_joints();
  state.time = next_time(state);
  ++state.step;
}

/// A sum of many steps would drift away from the clock: as long as the time is that of the steps,
/// it stays so.
double PushChain::next_time(const State& state) const {
  const auto at = [&](std::int64_t step) { return double(step) * timestep_; };
  return state.time == at(state.step) ? at(state.step + 1) : state.time + timestep_;
}

void PushChain::push_all(State& state) {
  const auto step = static_cast<std::uint64_t>(state.step + 1);
  bool has_more = links_.empty();
  for (const Link& link : links_) {
    const RandomKey key{link.seed, key_.domain, key_.walker, step, 0};
    if (link.pusher->push({framework_, key, timestep_, damping_, past_.older()}, state, push_))
      has_more = true;
  }
  is_over_ = !has_more;
}

void PushChain::drop_repeated_joints() {
  std::vector<Joint>& joints = push_.joints;
  if (push_.all) joints.clear();
  if (joints.size() < 2) return;
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
}

void PushChain::take_back(State& state) {
  past_.take_back_step(state);
  push_.clear();
  --state.step;
  state.time = time_before_;
  is_over_ = was_over_;
}

}  // namespace pliant
