// SPDX-License-Identifier: MIT
#include "pliant/framework/graph.hpp"

#include <algorithm>
#include <limits>

namespace pliant {
namespace {

constexpr auto unset = std::numeric_limits<std::uint32_t>::max();

/// Depth-first search that closes a block whenever a subtree cannot reach above its entry joint.
class BlockSearch {
 public:
  explicit BlockSearch(const Framework& framework)
      : framework_(framework),
        entered_(framework.joint_count(), unset),
        low_(framework.joint_count(), 0),
        next_(framework.joint_count(), 0) {
    blocks_.of_bar.assign(framework.bar_count(), unset);
    blocks_.is_bridge.assign(framework.bar_count(), false);
  }

  Blocks run() {
    for (std::size_t i = 0; i < framework_.joint_count(); ++i)
      if (entered_[i] == unset) search_from(static_cast<Joint>(i));
    return std::move(blocks_);
  }

 private:
  struct Visit {
    Joint joint;
    BarIndex arrival;  ///< bar by which the joint was entered; unset at a root
  };

  void search_from(Joint root) {
    enter(root, unset);
    while (!path_.empty()) {
      const Visit top = path_.back();
      const auto around = framework_.neighbours(top.joint);
      if (next_[top.joint] < around.size()) {
        look_at(top, around[next_[top.joint]++]);
      } else {
        leave(top);
      }
    }
  }

  void enter(Joint joint, BarIndex arrival) {
    entered_[joint] = low_[joint] = clock_++;
    path_.push_back({joint, arrival});
  }

  void look_at(const Visit& here, const Incidence& at) {
    if (at.bar == here.arrival) return;
    if (entered_[at.joint] == unset) {
      open_bars_.push_back(at.bar);
      enter(at.joint, at.bar);
    } else if (entered_[at.joint] < entered_[here.joint]) {
      open_bars_.push_back(at.bar);
      low_[here.joint] = std::min(low_[here.joint], entered_[at.joint]);
    }
  }

  void leave(const Visit& done) {
    path_.pop_back();
    if (path_.empty()) return;
    const Joint parent = path_.back().joint;
    low_[parent] = std::min(low_[parent], low_[done.joint]);
    if (low_[done.joint] >= entered_[parent]) close_block(done.arrival);
  }

  void close_block(BarIndex first) {
    std::size_t size = 0;
    BarIndex bar = unset;
    while (bar != first) {
      bar = open_bars_.back();
      open_bars_.pop_back();
      blocks_.of_bar[bar] = static_cast<std::uint32_t>(blocks_.count);
      ++size;
    }
    if (size == 1) blocks_.is_bridge[first] = true, ++blocks_.bridge_count;
    blocks_.largest = std::max(blocks_.largest, size);
    ++blocks_.count;
  }

  const Framework& framework_;
  std::vector<std::uint32_t> entered_, low_, next_;
  std::vector<Visit> path_;
  std::vector<BarIndex> open_bars_;
  std::uint32_t clock_ = 0;
  Blocks blocks_;
};

}  // namespace

Components find_components(const Framework& framework) {
  Components found;
  found.of_joint.assign(framework.joint_count(), unset);
  std::vector<Joint> waiting;
  for (std::size_t i = 0; i < framework.joint_count(); ++i) {
    if (found.of_joint[i] != unset) continue;
    const auto id = static_cast<std::uint32_t>(found.count++);
    found.lowest_joint.push_back(static_cast<Joint>(i));
    found.of_joint[i] = id;
    waiting.assign(1, static_cast<Joint>(i));
    while (!waiting.empty()) {
      const Joint joint = waiting.back();
      waiting.pop_back();
      for (const Incidence& at : framework.neighbours(joint)) {
        if (found.of_joint[at.joint] != unset) continue;
        found.of_joint[at.joint] = id;
        waiting.push_back(at.joint);
      }
    }
  }
  return found;
}

Blocks find_blocks(const Framework& framework) { return BlockSearch(framework).run(); }

GraphFacts graph_facts(const Framework& framework) {
  const Blocks blocks = find_blocks(framework);
  GraphFacts facts;
  facts.joints = framework.joint_count();
  facts.bars = framework.bar_count();
  facts.components = find_components(framework).count;
  facts.cycles = facts.bars + facts.components - facts.joints;
  facts.bridges = blocks.bridge_count;
  facts.blocks = blocks.count - blocks.bridge_count;
  facts.bars_in_blocks = facts.bars - facts.bridges;
  facts.largest_block = facts.blocks > 0 ? blocks.largest : 0;
  return facts;
}

}  // namespace pliant
