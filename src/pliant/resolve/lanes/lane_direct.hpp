// SPDX-License-Identifier: MIT
// Techniques `newton` and `shake` on eight walkers at once, component after component.
#pragma once

#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

/// None where some component's bars are too entangled to be solved at once, or need damping (twice
/// as many bars as joints), and where units have shapes to keep.
std::unique_ptr<LaneMethod> make_lane_newton(const LaneSetting& setting);

/// None where some component's bars are too entangled to be solved at once, and where units have
/// shapes to keep.
std::unique_ptr<LaneMethod> make_lane_shake(const LaneSetting& setting);

}  // namespace pliant
