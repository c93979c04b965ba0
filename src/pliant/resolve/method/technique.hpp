// SPDX-License-Identifier: MIT
// A technique: how broken bars are resolved. An ordering with a weighting and the rule by which two
// joints share a correction, or a direct method. The table of them is in techniques.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "pliant/base/vec3.hpp"
#include "pliant/order/ordering.hpp"

namespace pliant {

/// One custom sweep: moves `positions` (N, Angstrom) nearer to positions at which all bars are
/// whole. `sweep` counts from 0 in each resolve. An exception leaves the resolve, and positions are
/// restored. Pinned joints, and z in a planar framework, do not change whatever it does.
using CustomSweep = std::function<void(std::span<Vec3> positions, std::int64_t sweep)>;

/// The name of a technique with a CustomSweep, which is not in techniques().
inline constexpr const char* custom_technique = "custom";

/// How broken bars are resolved.
struct Technique {
  std::string name = "auto";  ///< a name in techniques(), or `custom` with a sweep
  /// Share of the correction that the far joint of a tree bar takes, in [0, 1]; the near joint
  /// takes the rest. Non-tree bars are always shared equally. The thesis has 0.5, 0.75, 1.
  double weighting = 0.5;
  bool mass_weighted = false;  ///< multiply shares by inverse masses
  /// Only for `input`: an ordering with each bar once, in place of the order of the bars. Null:
  /// none.
  std::shared_ptr<const Ordering> ordering = {};
  /// Only for `custom`: called until all bars are whole, from the thread that resolves.
  CustomSweep sweep = {};
};

}  // namespace pliant
