// SPDX-License-Identifier: MIT
// pliant run --forces with a file of events: options that are allowed with it, and its settings.
#pragma once

#include <string_view>

#include "options/run_settings.hpp"

namespace pliant::app {

/// Parses the events of a force file from its text. The settings of the last step become those that
/// are recorded. Throws OptionError for options that contradict it.
void take_events(const CommandLine& line, RunSettings& settings, const Molecule& molecule,
                 std::string_view text);

}  // namespace pliant::app
