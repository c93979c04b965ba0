// SPDX-License-Identifier: MIT
// The pushers of one walker, one after another in each step, and the way back from it.
#pragma once

#include <memory>
#include <vector>

#include "pliant/perturb/past.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant {

class PushChain {
 public:
  /// The framework must outlive it. Of the key, seed and walker count.
  PushChain(const Framework& framework, const PerturbOptions& options, const RandomKey& key)
      : framework_(framework), timestep_(options.timestep), damping_(options.damping), key_(key) {}

  /// Acts after those that are there already. The first one's random numbers are those of the seed,
  /// each other's belong to its place.
  void add(std::shared_ptr<Pusher> pusher);

  /// Begins the next step: counts it, and lets all push. Throws what a pusher throws; the state is
  /// then as before.
  void push(State& state);
  /// What the last push() did.
  const Push& pushed() const { return push_; }
  /// Whether all pushers have said that their last push was their last; where there is none, never.
  bool is_over() const { return is_over_; }

  /// As before the last push(), bit by bit.
  void take_back(State& state);
  Past& past() { return past_; }

 private:
  struct Link {
    std::shared_ptr<Pusher> pusher;
    std::uint64_t seed;
  };

  void push_all(State& state);
  double next_time(const State& state) const;
  void drop_repeated_joints();

  const Framework& framework_;
  double timestep_, damping_;
  RandomKey key_;
  std::vector<Link> links_;
  Past past_;
  Push push_;
  double time_before_ = 0.0;
  bool is_over_ = false, was_over_ = false;
};

}  // namespace pliant
