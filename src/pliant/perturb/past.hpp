// SPDX-License-Identifier: MIT
// Where the joints of a walker were one and two steps ago: Verlet's velocities, and the way back.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Keeps state.previous up to date, and what it was before. Where it is known which joints the last
/// steps moved, at a cost of those alone. It knows nothing that does not follow from the state.
class Past {
 public:
  /// A step begins: state.previous becomes where the joints are.
  void begin_step(State& state);
  /// Only these joints have moved since begin_step(); of any step that this is not said of, any.
  void only_moved(std::span<const Joint> joints, std::span<const Joint> more);
  /// Positions and previous positions as they were before begin_step().
  void take_back_step(State& state);
  /// Somebody else may have changed the state.
  void forget() { last_.is_known = before_last_.is_known = false; }

  /// (N) since begin_step(): what state.previous was before it.
  std::span<const Vec3> older() const { return older_; }

 private:
  /// Which joints a step moved.
  struct Moved {
    bool is_known = false;
    std::vector<Joint> joints;
  };

  static void bring_up(const Moved& moved, const std::vector<Vec3>& from, std::vector<Vec3>& to);

  std::vector<Vec3> older_;
  Moved last_, before_last_;
};

}  // namespace pliant
