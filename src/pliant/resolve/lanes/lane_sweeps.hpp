// SPDX-License-Identifier: MIT
// Sweeps of an ordering over eight walkers at once: each bar is projected in all of them before the
// next. Walkers that are whole leave; the others continue.
#pragma once

#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

/// None for orderings that are asked again before each sweep (`random`, `bfs_random`, `bfs_adapt`):
/// they differ from walker to walker.
std::unique_ptr<LaneMethod> make_lane_sweeps(const LaneSetting& setting);

}  // namespace pliant
