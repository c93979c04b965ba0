// SPDX-License-Identifier: MIT
// The joints that a resolve has moved, in the order of their first moves, and their old positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A set of joints that can be cleared in time proportional to its members, not the framework.
class MovedJoints {
 public:
  void clear() {
    for (Joint joint : joints_) is_in_[joint] = 0;
    joints_.clear();
    before_.clear();
    holds_all_ = false;
  }

  /// Any joint may move from now on; their present positions are given (N).
  void note_all(std::span<const Vec3> positions) {
    clear();
    before_.assign(positions.begin(), positions.end());
    holds_all_ = true;
  }

  /// Makes room for the joints of a framework, to be noted one by one.
  void reserve(std::size_t joint_count) {
    if (is_in_.size() < joint_count) is_in_.resize(joint_count, 0);
  }

  /// Notes that `joint` is about to leave `position`; only its first note counts.
  void note(Joint joint, Vec3 position) {
    if (is_in_[joint]) return;
    is_in_[joint] = 1;
    joints_.push_back(joint);
    before_.push_back(position);
  }

  bool holds_all() const { return holds_all_; }
  /// Whether a joint was noted.
  bool holds(Joint joint) const { return is_in_[joint] != 0; }
  /// The joints noted one by one.
  std::span<const Joint> joints() const { return joints_; }

  /// (N) old positions of all joints, if holds_all().
  std::span<const Vec3> before() const {
    return holds_all_ ? std::span<const Vec3>(before_) : std::span<const Vec3>();
  }

  void put_back(std::span<Vec3> positions) const {
    if (holds_all_) std::copy(before_.begin(), before_.end(), positions.begin());
    for (std::size_t k = 0; k < joints_.size(); ++k) positions[joints_[k]] = before_[k];
  }

 private:
  std::vector<std::uint8_t> is_in_;  ///< empty until reserve()
  std::vector<Joint> joints_;
  std::vector<Vec3> before_;  ///< of joints_, or of all joints
  bool holds_all_ = false;
};

}  // namespace pliant
