// SPDX-License-Identifier: MIT
// Which joints a resolve has moved, in the order in which they moved first, and where they were.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A set of joints that is cleared in the time that its members take, not the framework.
class MovedJoints {
 public:
  explicit MovedJoints(std::size_t joint_count) : is_in_(joint_count, 0) {}

  void clear() {
    for (Joint joint : joints_) is_in_[joint] = 0;
    joints_.clear();
    before_.clear();
  }

  /// Notes that `joint` is about to leave `position`; what a joint's first note says stays.
  void note(Joint joint, Vec3 position) {
    if (is_in_[joint]) return;
    is_in_[joint] = 1;
    joints_.push_back(joint);
    before_.push_back(position);
  }

  bool holds(Joint joint) const { return is_in_[joint] != 0; }
  std::span<const Joint> joints() const { return joints_; }

  void put_back(std::span<Vec3> positions) const {
    for (std::size_t k = 0; k < joints_.size(); ++k) positions[joints_[k]] = before_[k];
  }

 private:
  std::vector<std::uint8_t> is_in_;
  std::vector<Joint> joints_;
  std::vector<Vec3> before_;
};

}  // namespace pliant
