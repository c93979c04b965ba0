// SPDX-License-Identifier: MIT
// The pushers of one walker, which act one after another in each step.
#pragma once

#include <memory>
#include <vector>

#include "pliant/perturb/past.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant {

class PushChain {
 public:
  /// The framework must outlive it. Only the seed and the walker of `key` are used.
  PushChain(const Framework& framework, const PerturbOptions& options, const RandomKey& key)
      : framework_(framework), timestep_(options.timestep), damping_(options.damping), key_(key) {}

  /// Adds a pusher that acts after the earlier ones. The first draws its random numbers from the
  /// seed itself, each other one from a seed that depends on its position in the chain.
  void add(std::shared_ptr<Pusher> pusher);

  /// Begins the next step: increases its number and calls all pushers. Throws what a pusher throws;
  /// the state is then unchanged.
  void push(State& state);
  /// The result of the last push().
  const Push& pushed() const { return push_; }
  /// Whether all pushers have ended; false if there is none.
  bool is_over() const { return is_over_; }

  /// Undoes the last push(), bit by bit.
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
