// SPDX-License-Identifier: MIT
// A technique: how broken bars are resolved. An ordering with a weighting and the rule by which two
// joints share a correction, or a direct method. The table of them is in techniques.hpp.
#pragma once

#include <memory>
#include <string>

#include "pliant/order/ordering.hpp"

namespace pliant {

/// How broken bars are resolved.
struct Technique {
  std::string name = "auto";  ///< a name in techniques()
  /// Share of the correction that the far joint of a tree bar takes, in [0, 1]; the near joint
  /// takes the rest. Non-tree bars are always shared half and half. The thesis has 0.5, 0.75, 1.
  double weighting = 0.5;
  bool mass_weighted = false;  ///< multiply shares by inverse masses
  /// For `input` alone: this ordering, each bar once, in place of the bars' own. Null: none.
  std::shared_ptr<const Ordering> ordering = {};
};

}  // namespace pliant
