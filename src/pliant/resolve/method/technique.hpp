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

/// One sweep of somebody's own making: moves `positions` (N, Angstrom) nearer to where all bars are
/// whole. `sweep` counts from 0 in each resolve. What it throws leaves the resolve, and positions
/// are put back. Pinned joints, and the height of what lies in a plane, stay whatever it does.
using CustomSweep = std::function<void(std::span<Vec3> positions, std::int64_t sweep)>;

/// The name of a technique that has a CustomSweep; it is none in techniques().
inline constexpr const char* custom_technique = "custom";

/// How broken bars are resolved.
struct Technique {
  std::string name = "auto";  ///< a name in techniques(), or `custom` with a sweep
  /// Share of the correction that the far joint of a tree bar takes, in [0, 1]; the near joint
  /// takes the rest. Non-tree bars are always shared half and half. The thesis has 0.5, 0.75, 1.
  double weighting = 0.5;
  bool mass_weighted = false;  ///< multiply shares by inverse masses
  /// For `input` alone: this ordering, each bar once, in place of the bars' own. Null: none.
  std::shared_ptr<const Ordering> ordering = {};
  /// For `custom` alone: called until all bars are whole, from whatever thread resolves.
  CustomSweep sweep = {};
};

}  // namespace pliant
