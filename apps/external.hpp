// SPDX-License-Identifier: MIT
// Subcommands that are programs of their own, as with git: `pliant NAME` runs `pliant-NAME`.
#pragma once

#include <string>

#include "command.hpp"

namespace pliant::app {

/// Path of the program pliant-NAME: beside the command, else in a folder of PATH; "" if there is
/// none.
std::string find_external(const std::string& name);

/// Where the command is, where that is not the path of this process's executable.
void set_own_path(const std::string& path);

/// Runs the program at `path` until it ends, with `input` as its standard input; its exit code.
/// Throws FileError with the system's reason if it cannot be run.
int run_with_input(const std::string& path, const Arguments& arguments, const std::string& input);

/// Becomes the program at `path`. Returns only if that fails.
void become(const std::string& path, const Arguments& arguments);

}  // namespace pliant::app
