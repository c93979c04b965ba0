// SPDX-License-Identifier: MIT
// Techniques `newton` and `shake` on eight walkers at once, component by component.
#pragma once

#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

/// None if some component cannot be solved at once (too much fill) or needs damping (twice as many
/// bars as joints), or if units have shapes to keep.
std::unique_ptr<LaneMethod> make_lane_newton(const LaneSetting& setting);

/// None if some component cannot be solved at once (too much fill), or if units have shapes to
/// keep.
std::unique_ptr<LaneMethod> make_lane_shake(const LaneSetting& setting);

}  // namespace pliant
