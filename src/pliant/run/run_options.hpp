// SPDX-License-Identifier: MIT
// Options of a run of one walker or several, and its observers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/resolve/method/lane_options.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {

/// Receives a frame; returns true to stop the run after it.
using Observer = std::function<bool(const Frame&)>;

/// Looks at a run while it continues, whatever `every` is. Must not change it.
struct Onlooker {
  /// Called after each step, and after the start, if set; it may wait. True: wants this frame.
  std::function<bool(std::int64_t step)> wants = {};
  std::function<void(const Frame&)> look = {};
};

/// What a run does. Checked once, at its start.
struct RunOptions {
  Technique technique = {};
  ResolveOptions resolve = {};    ///< its seed and walker are those of the whole run
  std::string perturb = "force";  ///< a name in perturbations()
  PerturbOptions perturb_options = {};
  /// if not empty: these forces replace `perturb`; the run ends with the last one
  std::vector<JointForce> replay = {};
  std::vector<std::int64_t> replay_counts = {};  ///< (S) number of forces in each step; empty: one
  /// if not empty, and nothing is replayed: it replaces `perturb`, until has_arrived()
  Guide guide = {};
  std::int64_t steps = 1000;  ///< steps to do; from 0
  std::int64_t every = 1;     ///< interval of the frames shown (with step 0); from 1
  /// The step at which the run began, if it continues one: steps count from there, and nothing is
  /// resolved or shown before the next step. None: it begins here.
  std::optional<std::int64_t> began = {};
  /// called with the push of each step after the step
  std::function<void(const Push&)> on_push = {};
  std::vector<std::shared_ptr<Pusher>> hands = {};  ///< act in each step after the other pushers
  Onlooker onlooker = {};
  LaneOptions lanes = {};  ///< for run_walkers; changes no result
  Log log = {};
};

/// Number of replayed steps; 0 if the run is no replay.
std::int64_t replayed_steps(const RunOptions& options);

/// One of several walkers that run together.
struct WalkerRun {
  State& state;              ///< stepped on
  std::uint64_t number = 0;  ///< replaces RunOptions::resolve.walker
  std::vector<Observer> observers = {};
  std::function<void(const Push&)> on_push = {};    ///< replaces RunOptions::on_push
  std::vector<std::shared_ptr<Pusher>> hands = {};  ///< replaces RunOptions::hands
  Onlooker onlooker = {};                           ///< replaces RunOptions::onlooker
  Log log = {};                                     ///< replaces RunOptions::log
  std::optional<std::int64_t> began = {};           ///< replaces RunOptions::began
};

}  // namespace pliant
