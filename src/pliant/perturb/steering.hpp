// SPDX-License-Identifier: MIT
// Steering (interactive forces): forces that another thread, a mouse or a socket sets.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "pliant/base/threads.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// Pulls on joints, step after step, until told otherwise. What is asked during a step acts from
/// the next one on; the same forces in each step give the same bits. Of one walker.
class Steering final : public Pusher {
 public:
  /// No force moves its joint by more than `longest_step` (Angstrom) in a step: one that would do
  /// so acts as the one that moves it so far. Throws OptionError if that is not above 0.
  explicit Steering(double longest_step = std::numeric_limits<double>::infinity());

  /// From the next step on these forces act, in place of those before; forces on one joint add up.
  /// From any thread. Throws OptionError if a force is not finite.
  void pull(std::span<const JointForce> forces);
  /// Nothing pulls from the next step on. From any thread.
  void release();

  /// Moves the joints by move_by_verlet. `out` tells the forces as they were asked for and as they
  /// acted. Throws OptionError if a joint does not exist. It never has pushed for the last time.
  bool push(const PushCall& call, State& state, Push& out) override;

 private:
  double longest_step_;
  Mutex mutex_;
  std::vector<JointForce> asked_;   ///< under the mutex
  std::vector<JointForce> acting_;  ///< a copy of them, in a step
};

}  // namespace pliant
