// SPDX-License-Identifier: MIT
// pliant run --forces with a file of events: which options go with it, and what it means to a run.
#pragma once

#include <string_view>

#include "options/run_settings.hpp"

namespace pliant::app {

/// Reads the events of a force file, whose text is given. The settings of its last
/// step become those that are recorded. Throws OptionError for options that contradict it.
void take_events(const CommandLine& line, RunSettings& settings, const Molecule& molecule,
                 std::string_view text);

}  // namespace pliant::app
