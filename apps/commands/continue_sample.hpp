// SPDX-License-Identifier: MIT
// pliant sample --continue: goes on with the frames of a trajectory.
#pragma once

#include "command_line.hpp"
#include "options/sample_settings.hpp"

namespace pliant::app {

/// Adds to settings.go_on the frames that are missing: they become what one sample without an end
/// between would have written. The last one that is there is made again, and must have its bits.
/// Prints what was done and returns the exit code. Throws OptionError where an option contradicts
/// the file, and as the library does.
int continue_sample(const CommandLine& line, SampleSettings& settings);

}  // namespace pliant::app
