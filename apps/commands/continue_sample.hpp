// SPDX-License-Identifier: MIT
// pliant sample --continue: adds the missing frames to a trajectory.
#pragma once

#include "command_line.hpp"
#include "options/sample_settings.hpp"

namespace pliant::app {

/// Adds the missing frames to settings.go_on, which give what a single sample would have written.
/// The last existing frame is made again, and must have the same bits. Prints a summary and returns
/// the exit code. Throws OptionError if an option contradicts the file, and as the library does.
int continue_sample(const CommandLine& line, SampleSettings& settings);

}  // namespace pliant::app
