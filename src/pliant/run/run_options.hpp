// SPDX-License-Identifier: MIT
// What a run is asked for, of one walker or of several, and who looks on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/walkers.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {

/// Looks at a frame; true asks the run to stop after it.
using Observer = std::function<bool(const Frame&)>;

/// Looks in at a run while it goes, whatever `every` says. Changes nothing in it.
struct Onlooker {
  /// Asked after each step, and after the start, if set; it may wait. True: look at this one.
  std::function<bool(std::int64_t step)> wants = {};
  std::function<void(const Frame&)> look = {};
};

/// What a run does. Checked once, at its start.
struct RunOptions {
  Technique technique = {};
  ResolveOptions resolve = {};    ///< its seed and walker are those of the whole run
  std::string perturb = "force";  ///< a name in perturbations()
  PerturbOptions perturb_options = {};
  std::vector<JointForce> replay = {};  ///< if not empty: these forces, one a step, in place of
                                        ///< `perturb`; the run ends with the last one
  std::vector<std::int64_t> replay_counts = {};  ///< (S) of them in each step; empty: one
  Guide guide = {};           ///< if not empty, and nothing is replayed: it is followed
                              ///< in place of `perturb`, until has_arrived()
  std::int64_t steps = 1000;  ///< steps to do; from 0
  std::int64_t every = 1;     ///< show every so many steps (and step 0); from 1
  /// The step at which the run began, if the state is one that it has reached: steps count from
  /// there, and nothing is resolved or shown before the next step. None: it begins here.
  std::optional<std::int64_t> began = {};
  std::function<void(const Push&)> on_push = {};    ///< told the push of each step once it is done
  std::vector<std::shared_ptr<Pusher>> hands = {};  ///< act in each step after what pushes it
  Onlooker onlooker = {};
  LaneOptions lanes = {};  ///< of run_walkers; changes no result
  Log log = {};
};

/// Steps that are replayed; 0: the run is no replay.
std::int64_t replayed_steps(const RunOptions& options);

/// One of several walkers that run together.
struct WalkerRun {
  State& state;              ///< stepped on
  std::uint64_t number = 0;  ///< in place of RunOptions::resolve.walker
  std::vector<Observer> observers = {};
  std::function<void(const Push&)> on_push = {};    ///< in place of RunOptions::on_push
  std::vector<std::shared_ptr<Pusher>> hands = {};  ///< in place of RunOptions::hands
  Onlooker onlooker = {};                           ///< in place of RunOptions::onlooker
  Log log = {};                                     ///< in place of RunOptions::log
  std::optional<std::int64_t> began = {};           ///< in place of RunOptions::began
};

}  // namespace pliant
