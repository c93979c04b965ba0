// SPDX-License-Identifier: MIT
// Keeps a plan that depends only on the root until the root changes.
#pragma once

#include <optional>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Remembers the root of the plan that its owner holds.
class PlanOfRoot {
 public:
  /// Calls `plan(root)` unless the last plan has this root.
  template <class Plan>
  void prepare(Joint root, Plan plan) {
    if (root_ == root) return;
    root_.reset();  // in case it throws
    plan(root);
    root_ = root;
  }

 private:
  std::optional<Joint> root_;
};

}  // namespace pliant
