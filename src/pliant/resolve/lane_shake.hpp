// SPDX-License-Identifier: MIT
// Technique `shake` on eight walkers at once, each along its own bars before the push.
#pragma once

#include "pliant/resolve/lane_method.hpp"

namespace pliant {

/// None where some component's bars are too entangled to be solved at once.
std::unique_ptr<LaneMethod> make_lane_shake(const LaneSetting& setting);

}  // namespace pliant
