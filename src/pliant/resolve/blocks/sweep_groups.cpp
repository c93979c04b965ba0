// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/sweep_groups.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {
namespace {

std::uint32_t add_group(BarGroups& groups, bool is_carried) {
  groups.joints.emplace_back();
  groups.is_carried.push_back(is_carried);
  return static_cast<std::uint32_t>(groups.joints.size() - 1);
}

void find_joints(const Framework& framework, BarGroups& groups) {
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    if (groups.of_bar[k] == no_group) continue;
    const Bar bar = framework.bars()[k];
    std::vector<Joint>& joints = groups.joints[groups.of_bar[k]];
    joints.insert(joints.end(), {bar.a, bar.b});
  }
  for (std::vector<Joint>& joints : groups.joints) {
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  }
}

/// The group of each component that has several pinned joints, no_group for the others.
std::vector<std::uint32_t> group_pinned_components(const Framework& framework,
                                                   const Components& components,
                                                   BarGroups& groups) {
  std::vector<std::size_t> pinned(components.count, 0);
  for (std::size_t i = 0; i < framework.joint_count(); ++i)
    if (framework.is_pinned(static_cast<Joint>(i))) ++pinned[components.of_node[i]];
  std::vector<std::uint32_t> group(components.count, no_group);
  for (std::size_t c = 0; c < components.count; ++c)
    if (pinned[c] > 1) group[c] = add_group(groups, false);
  return group;
}

}  // namespace

BarGroups group_all_bars(const Framework& framework) {
  BarGroups groups;
  add_group(groups, false);
  groups.of_bar.assign(framework.bar_count(), 0);
  if (framework.has_bars_only()) {
    find_joints(framework, groups);
  } else {
    groups.joints[0].resize(framework.joint_count());
    std::iota(groups.joints[0].begin(), groups.joints[0].end(), Joint{0});
  }
  return groups;
}

BarGroups group_ring_systems(const Framework& framework, const OutwardPlanner& planner) {
  BarGroups groups;
  const Components components = find_components(framework);
  const auto of_component = group_pinned_components(framework, components, groups);
  groups.of_bar.resize(framework.bar_count());
  for (std::size_t k = 0; k < framework.bar_count(); ++k)
    groups.of_bar[k] = of_component[components.of_node[framework.bars()[k].a]];
  for (const std::vector<BarIndex>& bars : planner.blocks()) {
    const bool is_carried = groups.of_bar[bars.front()] == no_group;
    groups.of_block.push_back(is_carried ? add_group(groups, true) : no_group);
    if (!is_carried) continue;
    for (BarIndex k : bars) groups.of_bar[k] = groups.of_block.back();
  }
  find_joints(framework, groups);
  return groups;
}

}  // namespace pliant
