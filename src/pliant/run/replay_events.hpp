// SPDX-License-Identifier: MIT
// Replays what a person did (force files with events) as a run.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// Options of a replay.
struct ReplayOptions {
  std::string_view file = "force file";    ///< for messages
  std::int64_t every = 1;                  ///< interval of the frames shown (with step 0); from 1
  std::function<bool()> should_stop = {};  ///< asked after each sweep and step
  Log log = {};
};

/// Checks that all settings and pins are valid for this framework, in order, without making a step.
/// Throws as replay_events() does for invalid ones.
void check_events(const Framework& framework, const State& state,
                  std::span<const ForceEvent> events, std::string_view file = "force file");

/// Moves `state` through the events, starting from the usual options: the same framework, state and
/// events give the bits of the original. Step 0, every `every`-th step and the last are shown.
/// Throws InputError naming file and line of an invalid event, and as run().
RunSummary replay_events(const Framework& framework, State& state,
                         std::span<const ForceEvent> events, const ReplayOptions& options,
                         const std::vector<Observer>& observers);

/// The options that a file records for a run with these events: the settings after the last event,
/// the number of steps, and the loosest tolerance, by which all frames are judged.
RunOptions options_after(RunOptions options, std::span<const ForceEvent> events,
                         const Framework& framework);

}  // namespace pliant
