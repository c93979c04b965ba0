// SPDX-License-Identifier: MIT
// Subcommands that are separate programs, as with git: `pliant NAME` runs `pliant-NAME`.
#pragma once

#include <filesystem>
#include <string>

#include "command.hpp"

namespace pliant::app {

/// Path of the program pliant-NAME next to the command, else in a folder of PATH; "" if there is
/// none.
std::filesystem::path find_external(const std::string& name);

/// Sets the path of the command, if that is not this process's executable.
void set_own_path(const std::filesystem::path& path);

/// Runs the program at `path` with `input` as its standard input. Returns its exit code. Throws
/// FileError with the system's reason if it cannot be run.
int run_with_input(const std::filesystem::path& path, const Arguments& arguments,
                   const std::string& input);

/// Replaces this process by the program pliant-NAME of the Python package. If there is none, says
/// how to install it and returns an exit code. Throws FileError if it cannot be run.
int run_program(const std::string& name, const Arguments& arguments);

}  // namespace pliant::app
