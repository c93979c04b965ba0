// SPDX-License-Identifier: MIT
// Technique `blocks` on eight walkers at once: the same outward pass, where each bridge and each
// block is solved in all walkers before the next.
#pragma once

#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

/// None if some block may need more than plain Newton steps in some walker (hubs of many bars, or
/// twice as many bars as joints).
std::unique_ptr<LaneMethod> make_lane_blocks(const LaneSetting& setting);

}  // namespace pliant
