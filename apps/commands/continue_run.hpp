// SPDX-License-Identifier: MIT
// pliant run --continue: goes on with the run of a trajectory.
#pragma once

#include "command_line.hpp"
#include "options/run_settings.hpp"

namespace pliant::app {

/// Steps on from where settings.go_on ends, or the files of walkers of that name, and adds the
/// frames: they become what one run without an end between would have written. A walker that was
/// never begun begins. Prints what was done and returns the exit code. Throws OptionError where an
/// option contradicts the file, and as the library does.
int continue_run(const CommandLine& line, RunSettings& settings);

}  // namespace pliant::app
