// SPDX-License-Identifier: MIT
// The rigid units around joints that were pushed, as bodies that hang on ground that stays: what a
// step has to look at in a molecule of any size.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "pliant/resolve/bodies/region/drawn_shapes.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "pliant/rigidity/unit_graph.hpp"

namespace pliant {

/// Plans a region in time proportional to it. Not thread-safe.
class RegionPlanner {
 public:
  /// The framework must outlive it; it has no pinned joints and is not planar. O(bars), once.
  explicit RegionPlanner(const Framework& framework);

  /// The units of `joints` (not empty) and those around them, nearest first over hinges
  /// as bodies, up to some `most_bodies`; short tails as a whole. A unit at the end of a tail (a
  /// methyl group) rides on the unit that holds it, unless it was pushed itself. Joints that the
  /// region shares with other units are the ground's, and where it hangs on the ground more than
  /// once, the loops are cut. Without others it moves freely. The plan is valid until the next
  /// call.
  const BodyPlan& plan(std::span<const Joint> joints, std::size_t most_bodies);

  bool has_loops() const { return graph_.has_loops(); }

  /// The units of the bodies of the last plan, each after those on which it hangs.
  std::span<const UnitPlaces> units() const { return units_; }

 private:
  void clear();
  void choose(std::span<const Joint> joints);
  void take(std::uint32_t unit, bool is_seed);
  void take_around(std::uint32_t unit);
  void take_tails();
  bool find_tail(std::uint32_t unit);
  void place_ground();
  bool has_unit_outside(Joint joint) const;
  void hang_on_ground(std::uint32_t unit);
  void add_tree(std::uint32_t unit, UnitNode from);
  void add_tree_of_own(std::uint32_t unit);
  void add_body(std::uint32_t unit, UnitNode from, std::uint32_t parent);
  void add_unit(std::uint32_t unit, UnitPlaces places);
  void add_riders(std::uint32_t unit);
  void end_tree(std::uint32_t first);

  bool is_end(std::uint32_t unit) const { return graph_.links.at(unit).size() == 1; }
  bool may_ride(std::uint32_t unit) const;
  template <class Visit>
  void visit_around(std::uint32_t unit, const Visit& visit) const;

  UnitSet set_;
  UnitGraph graph_;
  UnitsOfJoints units_of_;
  BodyPlan plan_;
  std::vector<UnitPlaces> units_;
  std::vector<std::uint32_t> first_unit_;  ///< (bodies) of units_
  std::vector<std::uint32_t> region_;      ///< units, nearest first
  std::vector<std::uint8_t> is_in_;        ///< (units) 1: in the region, 2: and pushed
  std::vector<std::uint32_t> body_of_;     ///< (units)
  std::size_t bodies_ = 0;                 ///< units of the region that will be bodies
  std::size_t most_bodies_ = 0;
  std::vector<std::uint32_t> tail_;
  /// A unit to be added, the connection over which it hangs, and the body there.
  struct Waiting {
    std::uint32_t unit;
    UnitNode from;
    std::uint32_t parent;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace pliant
