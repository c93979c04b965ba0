// SPDX-License-Identifier: MIT
#include "pliant/perturb/past.hpp"

#include <utility>

namespace pliant {

/// Copies into place: others may look at the memory of `to`.
void Past::bring_up(const Moved& moved, const std::vector<Vec3>& from, std::vector<Vec3>& to) {
  if (moved.is_known) {
    for (Joint joint : moved.joints) to[joint] = from[joint];
  } else {
    to.assign(from.begin(), from.end());
  }
}

void Past::begin_step(State& state) {
  bring_up(before_last_, state.previous, older_);
  bring_up(last_, state.positions, state.previous);
  std::swap(last_, before_last_);
  last_.is_known = false;
}

void Past::only_moved(std::span<const Joint> joints, std::span<const Joint> more) {
  last_.is_known = true;
  last_.joints.assign(joints.begin(), joints.end());
  last_.joints.insert(last_.joints.end(), more.begin(), more.end());
}

void Past::take_back_step(State& state) {
  state.positions.assign(state.previous.begin(), state.previous.end());
  state.previous.assign(older_.begin(), older_.end());
  std::swap(last_, before_last_);
  before_last_.is_known = true;  // older_ is what state.previous is
  before_last_.joints.clear();
}

}  // namespace pliant
