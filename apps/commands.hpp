// SPDX-License-Identifier: MIT
// The table of subcommands, and how errors end them.
#pragma once

#include "command.hpp"

namespace pliant::app {

/// The pliant command, with the words after its name in UTF-8. Returns the exit code, an ExitCode;
/// errors have been printed.
int run_command(const Arguments& words);

}  // namespace pliant::app
