// SPDX-License-Identifier: MIT
// A technique: how broken bars are resolved. An ordering with a weighting and the rule by which two
// joints share a correction, or a direct method.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "pliant/framework/framework.hpp"
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

class Method;
class LaneMethod;
struct LaneSetting;
struct ResolveOptions;

/// One row of the table of techniques: every ordering is a row, and every direct method.
struct TechniqueEntry {
  std::string_view name;
  std::string_view summary;
  bool forests_only = false;  ///< leaves bars out that close a cycle
  bool has_weighting = true;  ///< Technique::weighting means something
  /// Makes what resolves; all three outlive it.
  std::unique_ptr<Method> (*make)(const Framework& framework, const Technique& technique,
                                  const ResolveOptions& options) = nullptr;
  /// Makes what resolves eight walkers at once, or none for such a framework. Null: no such way.
  std::unique_ptr<LaneMethod> (*make_lanes)(const LaneSetting& setting) = nullptr;
};

std::span<const TechniqueEntry> techniques();

/// The row of that name. Throws OptionError listing the known names.
const TechniqueEntry& find_technique(std::string_view name);

/// Throws OptionError if the technique is unknown, the weighting is not in [0, 1], or an ordering
/// goes with another technique than `input`.
void check(const Technique& technique);

/// Throws OptionError if the technique leaves bars of this framework out, or if its ordering is
/// none of this framework.
void check(const Technique& technique, const Framework& framework);

/// Shares (near, far) of a correction. They sum to 1; both are 0 when both joints are pinned. A
/// pinned joint takes nothing, and its partner all.
std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework);

}  // namespace pliant
