// SPDX-License-Identifier: MIT
// pliant run --continue: continues the run of a trajectory.
#pragma once

#include "command_line.hpp"
#include "options/run_settings.hpp"

namespace pliant::app {

/// Continues from the end of settings.go_on, or of the files of walkers of that name, and adds
/// frames, which give what a single run would have written. A walker that was never begun begins.
/// Prints a summary and returns the exit code. Throws OptionError if an option contradicts the
/// file, and as the library does.
int continue_run(const CommandLine& line, RunSettings& settings);

}  // namespace pliant::app
