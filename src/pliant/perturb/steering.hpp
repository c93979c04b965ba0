// SPDX-License-Identifier: MIT
// Steering (interactive forces): forces set from another thread, by a mouse or a socket.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "pliant/base/threads/threads.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// Pulls on the joints of one walker in each step until other forces are set. Forces set during a
/// step act from the next one on; the same forces in each step give the same bits.
class Steering final : public Pusher {
 public:
  /// A force that would move its joint by more than `longest_step` (Angstrom) in a step is reduced
  /// to one that moves it that far. Throws OptionError if longest_step is not above 0.
  explicit Steering(double longest_step = std::numeric_limits<double>::infinity());

  /// Sets the forces that act from the next step on; forces on one joint add up. May be called from
  /// any thread. Throws OptionError if a force is not finite.
  void pull(std::span<const JointForce> forces);
  /// Removes all forces from the next step on. May be called from any thread.
  void release();

  /// Moves the joints by move_by_verlet. `out` receives the forces as asked for and as applied.
  /// Throws OptionError if a joint does not exist. Always returns true.
  bool push(const PushCall& call, State& state, Push& out) override;

 private:
  double longest_step_;
  Mutex mutex_;
  std::vector<JointForce> asked_;   ///< guarded by the mutex
  std::vector<JointForce> acting_;  ///< their copy during a step
};

}  // namespace pliant
