// SPDX-License-Identifier: MIT
// The rigid units of a framework as a forest of bodies connected by hinges, numbered so that each
// joint belongs to the body that moves it and the joints of a body are consecutive.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/rigidity/unit_set.hpp"

namespace pliant {

/// The index of a joint in the plan's own numbering, called a place.
using Slot = std::uint32_t;

/// A rigid unit, connected to its parent by a hinge, a ball joint, or not at all.
struct PlanBody {
  std::int32_t parent = -1;      ///< index of an earlier body; -1: moves freely
  Slot first = 0, last = 0;      ///< its own joints, [first, last)
  Slot a = 0, b = 0;             ///< joints shared with its parent; equal for a ball joint
  std::uint32_t first_turn = 0;  ///< first of its turns among those of all bodies
  std::uint32_t turns() const { return parent < 0 ? 0 : (a == b ? 3 : 1); }
};

/// Bodies [first, last) that are connected, the root first.
struct BodyTree {
  std::uint32_t first = 0, last = 0;
};

/// A cut of a loop of bodies: two places of one joint, which must coincide.
struct LoopCut {
  Slot copy, joint;
};

/// The units that become bodies: rigid units, rigid rings as one, and each joint that is in none.
UnitSet units_of_bodies(const Framework& framework);

class BodyPlan {
 public:
  /// No bodies.
  BodyPlan() = default;
  /// Makes the bodies of the framework's rigid units; rigid rings are one body. Each component
  /// begins at the middle of its longest path of bodies. Where bodies form loops, a body has copies
  /// of the joints at which a loop was cut. Null if there are pinned joints, or if the framework
  /// has loops and is not drawn.
  static std::optional<BodyPlan> make(const Framework& framework);

  std::span<const PlanBody> bodies() const { return bodies_; }
  std::span<const BodyTree> trees() const { return trees_; }
  std::uint32_t tree_of(std::uint32_t body) const { return tree_of_[body]; }
  std::size_t turn_count() const { return turn_count_; }
  std::size_t place_count() const { return joint_at_.size(); }
  std::span<const Joint> joint_at() const { return joint_at_; }  ///< of each place, copies included
  Slot place_of(Joint joint) const { return place_of_[joint]; }
  std::span<const std::uint32_t> body_at() const { return body_at_; }  ///< of each place
  std::span<const LoopCut> cuts() const { return cuts_; }
  /// Where a body has a joint of its unit: among its own, else where its ancestors have it.
  Slot place_in(std::uint32_t body, Joint joint) const;
  /// The largest distance between the two places of a cut at `x` (places, Angstrom).
  double widest_gap(std::span<const Vec3> x) const;
  /// Whether a body is the ground: a root that never moves, to which a part of a molecule is tied.
  bool is_ground(std::uint32_t body) const { return body == ground_; }

 private:
  friend class BodyPlanner;
  friend class RegionPlanner;

  static constexpr Slot no_place = ~Slot{0};

  /// A joint that has a place already (the ground's, or another branch's) gets a copy: a loop is
  /// cut.
  void add_place(Joint joint, std::uint32_t body);

  std::vector<PlanBody> bodies_;
  std::vector<BodyTree> trees_;
  std::vector<std::uint32_t> tree_of_;  ///< (bodies)
  std::size_t turn_count_ = 0;
  std::vector<Joint> joint_at_;
  std::vector<Slot> place_of_;
  std::vector<std::uint32_t> body_at_;
  std::vector<LoopCut> cuts_;
  std::uint32_t ground_ = ~std::uint32_t{0};  ///< none
};

}  // namespace pliant
