// SPDX-License-Identifier: MIT
// Replaying what a person did (force files with events) as a run.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// How to show it.
struct ReplayOptions {
  std::string_view file = "force file";    ///< for messages
  std::int64_t every = 1;                  ///< show every so many steps (and step 0); from 1
  std::function<bool()> should_stop = {};  ///< asked after each sweep and step
  Log log = {};
};

/// Whether all settings and pins make sense for this framework, one after the other; makes no step.
/// Throws as replay_events() does for those that make none.
void check_events(const Framework& framework, const State& state,
                  std::span<const ForceEvent> events, std::string_view file = "force file");

/// Steps `state` on as the events say, from the usual options on: the same framework, state and
/// events give the same bits as when they were made. Step 0 is shown, every `every`-th and the
/// last. Throws InputError naming file and line of an event that makes no sense, and as run().
RunSummary replay_events(const Framework& framework, State& state,
                         std::span<const ForceEvent> events, const ReplayOptions& options,
                         const std::vector<Observer>& observers);

/// Options as a file records them of a run that these events make of `options`: the settings after
/// the last event, as many steps, and the loosest tolerance of any, by which all frames are judged.
RunOptions options_after(RunOptions options, std::span<const ForceEvent> events,
                         const Framework& framework);

}  // namespace pliant
