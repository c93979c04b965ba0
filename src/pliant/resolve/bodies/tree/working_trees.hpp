// SPDX-License-Identifier: MIT
// The trees of a plan of bodies that a resolve moves. A tree on which nothing pulls and which no
// contact touches does not move by a bit, so that no step has to visit it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// A set of trees that can be cleared in time proportional to its members.
class WorkingTrees {
 public:
  /// The plan must outlive it. Starts with all trees.
  explicit WorkingTrees(const BodyPlan& plan) : plan_(plan), is_in_(plan.trees().size(), 0) {
    add_all();
  }

  /// Starts again with all trees of the plan, which has changed.
  void fit() {
    is_in_.assign(plan_.trees().size(), 0);
    numbers_.clear();
    bodies_.clear();
    add_all();
  }

  void clear() {
    for (std::uint32_t tree : numbers_) is_in_[tree] = 0;
    numbers_.clear();
    bodies_.clear();
  }

  void add(std::uint32_t tree) {
    if (is_in_[tree] != 0) return;
    is_in_[tree] = 1;
    numbers_.push_back(tree);
    for (std::uint32_t body = plan_.trees()[tree].first; body < plan_.trees()[tree].last; ++body)
      bodies_.push_back(body);
  }

  void add_all() {
    for (std::uint32_t tree = 0; tree < is_in_.size(); ++tree) add(tree);
  }

  bool holds(std::uint32_t tree) const { return is_in_[tree] != 0; }
  /// Bodies of these trees, parents first.
  std::span<const std::uint32_t> bodies() const { return bodies_; }

 private:
  const BodyPlan& plan_;
  std::vector<std::uint8_t> is_in_;     ///< (trees)
  std::vector<std::uint32_t> numbers_;  ///< of those in it
  std::vector<std::uint32_t> bodies_;
};

}  // namespace pliant
