// SPDX-License-Identifier: MIT
// The table of subcommands, and how errors end them.
#pragma once

namespace pliant::app {

/// The pliant command: argv[0] is its own path, as in main(). Returns the exit code, an ExitCode;
/// errors have been printed.
int run_command(int argc, char** argv);

}  // namespace pliant::app
