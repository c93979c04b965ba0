// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/outward_plan.hpp"

namespace pliant {

OutwardPlanner::OutwardPlanner(const Framework& framework) : framework_(framework) {
  const Blocks found = find_blocks(framework);
  std::vector<std::uint32_t> place(found.count, no_block);
  block_of_bar_.assign(framework.bar_count(), no_block);
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    if (found.is_bridge[k]) continue;
    std::uint32_t& at = place[found.of_edge[k]];
    if (at == no_block) {
      at = static_cast<std::uint32_t>(blocks_.size());
      blocks_.emplace_back();
    }
    block_of_bar_[k] = at;
    blocks_[at].push_back(static_cast<BarIndex>(k));
  }
}

void OutwardPlanner::plan(Joint root, std::vector<OutwardStep>& out) {
  out.clear();
  reached_.assign(framework_.joint_count(), false);
  entered_.assign(blocks_.size(), false);
  queue_.clear();
  next_ = 0;
  const auto go_from = [&](Joint joint) {
    if (reached_[joint]) return;
    start(joint);
    while (next_ < queue_.size()) take(queue_[next_++], out);
  };
  if (framework_.has_pinned_joints())
    for (std::size_t i = 0; i < framework_.joint_count(); ++i)
      if (framework_.is_pinned(static_cast<Joint>(i))) go_from(static_cast<Joint>(i));
  if (framework_.joint_count() > 0) go_from(root);
  for (std::size_t i = 0; i < framework_.joint_count(); ++i) go_from(static_cast<Joint>(i));
}

void OutwardPlanner::start(Joint joint) {
  reached_[joint] = true;
  queue_.push_back(joint);
}

void OutwardPlanner::take(Joint joint, std::vector<OutwardStep>& out) {
  for (const Incidence& at : framework_.neighbours(joint)) {
    const std::uint32_t block = block_of_bar_[at.bar];
    if (block != no_block) {
      if (!entered_[block]) enter_block(block, joint, out);
    } else if (!reached_[at.joint]) {
      start(at.joint);
      out.push_back({joint, at.joint, at.bar, no_block});
    }
  }
}

void OutwardPlanner::enter_block(std::uint32_t block, Joint entry, std::vector<OutwardStep>& out) {
  entered_[block] = true;
  out.push_back({entry, entry, 0, block});
  for (BarIndex k : blocks_[block]) {
    const Bar bar = framework_.bars()[k];
    for (Joint joint : {bar.a, bar.b})
      if (!reached_[joint]) start(joint);
  }
}

}  // namespace pliant
