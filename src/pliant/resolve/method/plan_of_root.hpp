// SPDX-License-Identifier: MIT
// A plan that depends on the root alone is kept until the root changes.
#pragma once

#include <optional>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Remembers the root of the plan that its owner holds.
class PlanOfRoot {
 public:
  /// Calls `plan(root)` unless the last one made is of this root.
  template <class Plan>
  void prepare(Joint root, Plan plan) {
    if (root_ == root) return;
    root_.reset();  // in case it throws half way
    plan(root);
    root_ = root;
  }

 private:
  std::optional<Joint> root_;
};

}  // namespace pliant
