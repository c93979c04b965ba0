// SPDX-License-Identifier: MIT
// The rigid units of a framework as a forest of bodies that hang on each other by hinges, numbered
// so that each joint belongs to the body that moves it and the joints of a body follow each other.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A place in the plan's own numbering of joints.
using Slot = std::uint32_t;

/// A rigid unit, hanging on its parent by a hinge, a ball, or not at all.
struct PlanBody {
  std::int32_t parent = -1;      ///< comes before; -1: moves freely
  Slot first = 0, last = 0;      ///< its own joints, [first, last)
  Slot a = 0, b = 0;             ///< the joints that it shares with its parent; a == b: a ball
  std::uint32_t first_turn = 0;  ///< of its turns, among those of all bodies
  std::uint32_t turns() const { return parent < 0 ? 0 : (a == b ? 3 : 1); }
};

/// Bodies [first, last) that hang together, their root first.
struct BodyTree {
  std::uint32_t first = 0, last = 0;
};

/// Where a loop of bodies was cut: two places of one joint, which must come to lie together.
struct LoopCut {
  Slot copy, joint;
};

class BodyPlan {
 public:
  /// Bodies of the framework's rigid units; rings that are rigid are one body. Each component
  /// begins at the middle of its longest path of bodies. Where bodies hang together in loops, a
  /// body has copies of the joints at which the loop was cut. Null if there are pinned joints, or
  /// if nothing is known of the shape of the framework (it is not drawn) but its loops.
  static std::optional<BodyPlan> make(const Framework& framework);

  std::span<const PlanBody> bodies() const { return bodies_; }
  std::span<const BodyTree> trees() const { return trees_; }
  std::uint32_t tree_of(std::uint32_t body) const { return tree_of_[body]; }
  std::size_t turn_count() const { return turn_count_; }
  std::size_t place_count() const { return joint_at_.size(); }
  std::span<const Joint> joint_at() const { return joint_at_; }  ///< of each place, copies too
  Slot place_of(Joint joint) const { return place_of_[joint]; }
  std::span<const std::uint32_t> body_at() const { return body_at_; }  ///< of each place
  std::span<const LoopCut> cuts() const { return cuts_; }

 private:
  BodyPlan() = default;
  friend class BodyPlanner;

  std::vector<PlanBody> bodies_;
  std::vector<BodyTree> trees_;
  std::vector<std::uint32_t> tree_of_;  ///< of each body
  std::size_t turn_count_ = 0;
  std::vector<Joint> joint_at_;
  std::vector<Slot> place_of_;
  std::vector<std::uint32_t> body_at_;
  std::vector<LoopCut> cuts_;
};

}  // namespace pliant
