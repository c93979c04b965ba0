// SPDX-License-Identifier: MIT
// The table of subcommands, and what an error ends with.
#pragma once

namespace pliant::app {

/// The pliant command: argv[0] is its own path, as main() is given it. Returns the exit code, an
/// ExitCode; an error has been printed.
int run_command(int argc, char** argv);

}  // namespace pliant::app
