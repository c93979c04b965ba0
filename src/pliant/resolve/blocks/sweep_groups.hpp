// SPDX-License-Identifier: MIT
// Which bars must be swept together, and which can be put right by carrying what hangs on them.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "pliant/resolve/blocks/outward_plan.hpp"

namespace pliant {

inline constexpr auto no_group = std::numeric_limits<std::uint32_t>::max();

/// Groups of bars that are swept together.
struct BarGroups {
  std::vector<std::uint32_t> of_bar;       ///< (B) no_group for a bridge that is carried over
  std::vector<std::uint32_t> of_block;     ///< (blocks) the group carried with a block, or no_group
  std::vector<std::vector<Joint>> joints;  ///< of each group, sorted
  std::vector<bool> is_carried;            ///< of each group: it is a block
};

/// All bars in one group; its joints are all joints where limits or sterics may move any.
BarGroups group_all_bars(const Framework& framework);

/// A group for each block, but one for each component that has several pinned joints.
BarGroups group_ring_systems(const Framework& framework, const OutwardPlanner& planner);

}  // namespace pliant
