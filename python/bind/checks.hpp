// SPDX-License-Identifier: MIT
// Indices from Python, checked before they become unsigned.
#pragma once

#include <string>

#include "bind.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant::python {

[[noreturn]] inline void fail_index(const char* what, std::int64_t index, std::size_t count) {
  throw nb::index_error((std::string(what) + " " + std::to_string(index) + " of " +
                         std::to_string(count) + " does not exist")
                            .c_str());
}

/// Throws IndexError "joint 7 of 5 does not exist".
inline Joint joint_at(const Framework& framework, std::int64_t joint) {
  if (joint < 0 || static_cast<std::uint64_t>(joint) >= framework.joint_count())
    fail_index("joint", joint, framework.joint_count());
  return static_cast<Joint>(joint);
}

/// Throws IndexError "bar 7 of 5 does not exist".
inline Bar bar_at(const Framework& framework, std::int64_t bar) {
  if (bar < 0 || static_cast<std::uint64_t>(bar) >= framework.bar_count())
    fail_index("bar", bar, framework.bar_count());
  return framework.bars()[static_cast<std::size_t>(bar)];
}

/// The root joint of a resolve; a framework without joints needs none.
inline Joint root_at(const Framework& framework, std::int64_t root) {
  return framework.joint_count() == 0 ? 0 : joint_at(framework, root);
}

}  // namespace pliant::python
