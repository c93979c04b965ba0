// SPDX-License-Identifier: MIT
// Positions of a walker one and two steps ago, for Verlet's velocities and for taking a step back.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Keeps state.previous up to date, and a copy of its value before. Costs only as much as the last
/// steps moved, if it is known which joints these were. All that it knows follows from the state.
class Past {
 public:
  /// Begins a step: state.previous becomes the current positions.
  void begin_step(State& state);
  /// Says that only these joints have moved since begin_step(). Without such a call, any may have.
  void only_moved(std::span<const Joint> joints, std::span<const Joint> more);
  /// Restores positions and previous positions as they were before begin_step().
  void take_back_step(State& state);
  /// Must be called when others may have changed the state.
  void forget() { last_.is_known = before_last_.is_known = false; }

  /// (N) state.previous as it was before begin_step().
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
