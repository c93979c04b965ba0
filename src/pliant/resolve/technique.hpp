// SPDX-License-Identifier: MIT
// A technique: an ordering with a weighting, and the rule by which two joints share a correction.
#pragma once

#include <string>
#include <utility>

#include "pliant/framework/framework.hpp"
#include "pliant/order/ordering.hpp"

namespace pliant {

/// How broken bars are resolved.
struct Technique {
  std::string name = "bfs_cycle";  ///< a name in orderings()
  /// Share of the correction that the far joint of a tree bar takes, in [0, 1]; the near joint
  /// takes the rest. Non-tree bars are always shared half and half. The thesis has 0.5, 0.75, 1.
  double weighting = 0.5;
  bool mass_weighted = false;  ///< multiply shares by inverse masses
};

/// Throws OptionError if the ordering is unknown or the weighting is not in [0, 1].
void check(const Technique& technique);

/// Throws OptionError if the technique leaves bars of this framework out.
void check(const Technique& technique, const Framework& framework);

/// Shares (near, far) of a correction. They sum to 1; both are 0 when both joints are pinned. A
/// pinned joint takes nothing, and its partner all.
std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework);

}  // namespace pliant
