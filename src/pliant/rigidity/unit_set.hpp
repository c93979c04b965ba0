// SPDX-License-Identifier: MIT
// Rigid units of a framework (rigid clusters, FRODA's ghost templates) by its graph: an atom with
// its neighbours if all their distances are fixed, extended by every joint that three bars hold in
// place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Sets of joints, one for each unit, in ascending order.
using UnitSet = Grouped<Joint>;

/// Which units each joint is in, ascending.
class UnitsOfJoints {
 public:
  UnitsOfJoints(const UnitSet& set, std::size_t joint_count);

  std::span<const std::uint32_t> at(Joint joint) const { return units_.at(joint); }
  /// Fills `out` with the units that hold both joints, ascending.
  void common(Joint a, Joint b, std::vector<std::uint32_t>& out) const;

 private:
  Grouped<std::uint32_t> units_;  ///< (N) units of each joint
};

/// Units of three or more joints, followed by a rod (a unit of two joints) for each bar that is in
/// none of them. A unit begins with a triangle of bars and grows by joints that have bars to three
/// joints of it which are not on a line. Joints with more than 256 bars are in rods only.
/// O(bars^1.5) at worst, linear where joints have few bars.
UnitSet find_units(const Framework& framework);

}  // namespace pliant
