// SPDX-License-Identifier: MIT
#include "pliant/order/traversal.hpp"

#include <limits>

namespace pliant {
namespace {

constexpr auto no_bar = std::numeric_limits<BarIndex>::max();
enum Mark : std::uint8_t { unseen = 0, seen = 1, taken = 2 };

/// What both traversals share: marks, and the walk over components.
struct Walk {
  const Framework& framework;
  bool with_non_tree_bars;
  OrderScratch& scratch;
  Ordering& out;

  void clear() {
    out.clear();
    scratch.joint_mark.assign(framework.joint_count(), unseen);
    scratch.arrival.resize(framework.joint_count());
    scratch.queue.clear();
  }

  void enter(Joint joint, BarIndex arrival) {
    scratch.joint_mark[joint] = seen;
    scratch.arrival[joint] = arrival;
    scratch.queue.push_back(joint);
  }

  template <class From>
  void all_components(Joint root, From from) {
    if (framework.joint_count() == 0) return;
    from(root);
    for (std::size_t i = 0; i < framework.joint_count(); ++i)
      if (scratch.joint_mark[i] == unseen) from(static_cast<Joint>(i));
  }
};

void take_breadth_first(Walk& walk, Joint joint) {
  OrderScratch& scratch = walk.scratch;
  scratch.later.clear();
  for (const Incidence& at : walk.framework.neighbours(joint)) {
    if (scratch.joint_mark[at.joint] == unseen) {
      walk.out.push_back({at.bar, joint, true});
      walk.enter(at.joint, at.bar);
    } else if (scratch.joint_mark[at.joint] == taken && at.bar != scratch.arrival[joint]) {
      scratch.later.push_back({at.bar, at.joint, false});
    }
  }
  if (walk.with_non_tree_bars)
    walk.out.insert(walk.out.end(), scratch.later.begin(), scratch.later.end());
  scratch.joint_mark[joint] = taken;
}

/// One look at the joint on top of the stack: either a bar of it, or back to its parent.
void step_depth_first(Walk& walk) {
  OrderScratch& scratch = walk.scratch;
  const Joint joint = scratch.queue.back();
  const auto around = walk.framework.neighbours(joint);
  if (scratch.next[joint] == around.size()) {
    scratch.queue.pop_back();
    return;
  }
  const Incidence at = around[scratch.next[joint]++];
  if (scratch.bar_mark[at.bar] != unseen) return;
  scratch.bar_mark[at.bar] = seen;
  const bool is_tree = scratch.joint_mark[at.joint] == unseen;
  // A non-tree bar is met from its far end: it leads back to a joint that is still on the stack.
  if (is_tree || walk.with_non_tree_bars)
    walk.out.push_back({at.bar, is_tree ? joint : at.joint, is_tree});
  if (is_tree) walk.enter(at.joint, at.bar);
}

}  // namespace

void traverse_breadth_first(const Framework& framework, Joint root, bool with_non_tree_bars,
                            OrderScratch& scratch, Ordering& out) {
  Walk walk{framework, with_non_tree_bars, scratch, out};
  walk.clear();
  std::size_t next = 0;
  walk.all_components(root, [&](Joint start) {
    walk.enter(start, no_bar);
    while (next < scratch.queue.size()) take_breadth_first(walk, scratch.queue[next++]);
  });
}

void traverse_depth_first(const Framework& framework, Joint root, bool with_non_tree_bars,
                          OrderScratch& scratch, Ordering& out) {
  Walk walk{framework, with_non_tree_bars, scratch, out};
  walk.clear();
  scratch.bar_mark.assign(framework.bar_count(), unseen);
  scratch.next.assign(framework.joint_count(), 0);
  walk.all_components(root, [&](Joint start) {
    walk.enter(start, no_bar);
    while (!scratch.queue.empty()) step_depth_first(walk);
  });
}

}  // namespace pliant
