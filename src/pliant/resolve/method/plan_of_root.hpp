// SPDX-License-Identifier: MIT
// Keeps a plan that depends only on the root until the root changes.
#pragma once

#include <optional>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Remembers the root of the plan that its owner holds.
class PlanOfRoot {
 public:
  /// Calls `make(root)` unless the last plan has this root.
  template <class Make>
  void prepare(Joint root, Make make) {
    if (root_ == root) return;
    root_.reset();  // in case it throws
    make(root);
    root_ = root;
  }

 private:
  std::optional<Joint> root_;
};

}  // namespace pliant
