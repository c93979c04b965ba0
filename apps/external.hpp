// SPDX-License-Identifier: MIT
// Subcommands that are separate programs, as with git: `pliant NAME` runs `pliant-NAME`.
#pragma once

#include <string>

#include "command.hpp"

namespace pliant::app {

/// Path of the program pliant-NAME next to the command, else in a folder of PATH; "" if there is
/// none.
std::string find_external(const std::string& name);

/// Sets the path of the command, if that is not this process's executable.
void set_own_path(const std::string& path);

/// Runs the program at `path` with `input` as its standard input. Returns its exit code. Throws
/// FileError with the system's reason if it cannot be run.
int run_with_input(const std::string& path, const Arguments& arguments, const std::string& input);

/// Replaces this process by the program pliant-NAME of the Python package. If there is none, says
/// how to install it and returns an exit code. Throws FileError if it cannot be run.
int run_program(const std::string& name, const Arguments& arguments);

/// Replaces this process by the program at `path`. Returns only if that fails.
void become(const std::string& path, const Arguments& arguments);

}  // namespace pliant::app
