// SPDX-License-Identifier: MIT
#include "pliant/rigidity/joint_pebbles.hpp"

#include <algorithm>

namespace pliant {

JointPebbles::JointPebbles(std::size_t joints, std::uint32_t dimension)
    : in_space_(dimension == 3),
      pebbles_(joints, {free, free, in_space_ ? free : unused}),
      neighbours_(joints),
      steps_(joints),
      marks_(joints, 0) {}

bool JointPebbles::add(Joint a, Joint b) {
  if (!gather(a, b) || !gather(b, a) || (in_space_ && is_in_full_set(a, b))) return false;
  pebbles_[a][0] = b;
  neighbours_[a].push_back(b);
  neighbours_[b].push_back(a);
  return true;
}

bool JointPebbles::pays_for_bar_to(Joint joint, Joint other) const {
  return std::count(pebbles_[joint].begin(), pebbles_[joint].end(), other) > 0;
}

/// Frees all pebbles of `to`, but takes none from `other`.
bool JointPebbles::gather(Joint to, Joint other) {
  const auto pays = [](Joint at) { return at < unused; };
  while (std::any_of(pebbles_[to].begin(), pebbles_[to].end(), pays))
    if (!fetch_pebble(to, to, other)) return false;
  return true;
}

/// With all six pebbles at a and b, a third joint of a set that has all bars it can take gets none.
/// In every such set a joint pays for a bar to a or to b.
bool JointPebbles::is_in_full_set(Joint a, Joint b) {
  for (const Joint end : {a, b})
    for (const Joint joint : neighbours_[end]) {
      if (!pays_for_bar_to(joint, end) || pays_for_bar_to(joint, free)) continue;
      if (!fetch_pebble(joint, a, b)) return true;
    }
  return false;
}

/// Brings a free pebble to a joint, the nearest first, and leaves those of a and b.
bool JointPebbles::fetch_pebble(Joint to, Joint a, Joint b) {
  begin_search(to, a, b);
  for (std::size_t k = 0; k < reached_.size(); ++k)
    for (std::uint32_t p = 0; p < 3; ++p) {
      const Joint next = pebbles_[reached_[k]][p];
      if (next >= unused || marks_[next] == search_) continue;
      marks_[next] = search_;
      steps_[next] = {reached_[k], p};
      if (pays_for_bar_to(next, free)) {
        carry_back(next);
        return true;
      }
      reached_.push_back(next);
    }
  return false;
}

void JointPebbles::begin_search(Joint from, Joint a, Joint b) {
  if (++search_ == 0) {  // after 2^32 searches marks would repeat
    std::fill(marks_.begin(), marks_.end(), 0);
    search_ = 1;
  }
  reached_.assign({from});
  steps_[from].from = free;
  for (const Joint joint : {from, a, b}) marks_[joint] = search_;
}

/// Each bar on the way back to where the search began is paid for by its other end.
void JointPebbles::carry_back(Joint joint) {
  while (steps_[joint].from != free) {
    const auto [from, pebble] = steps_[joint];
    *std::find(pebbles_[joint].begin(), pebbles_[joint].end(), free) = from;
    pebbles_[from][pebble] = free;
    joint = from;
  }
}

}  // namespace pliant
