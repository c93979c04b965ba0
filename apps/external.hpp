// SPDX-License-Identifier: MIT
// Subcommands that are programs of their own, as with git: `pliant NAME` runs `pliant-NAME`.
#pragma once

#include <string>

#include "command.hpp"

namespace pliant::app {

/// Path of the program pliant-NAME: beside this executable, else in a folder of PATH; "" if there
/// is none.
std::string find_external(const std::string& name);

/// Becomes the program at `path`. Returns only if that fails.
void become(const std::string& path, const Arguments& arguments);

}  // namespace pliant::app
