// SPDX-License-Identifier: MIT
// Technique `blocks` on eight walkers at once: the same outward pass, each bridge and each block in
// all of them before the next.
#pragma once

#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

/// None where some block needs more than plain Newton steps in any walker (hubs of many bars, or
/// twice as many bars as joints).
std::unique_ptr<LaneMethod> make_lane_blocks(const LaneSetting& setting);

}  // namespace pliant
