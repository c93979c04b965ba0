// SPDX-License-Identifier: MIT
// Options of the command line from rows of a table of options.
#pragma once

#include <string>
#include <string_view>

#include "command_line.hpp"
#include "pliant/base/option_fields.hpp"

namespace pliant::app {

/// "--max-sweeps" of "max_sweeps".
std::string option_name(std::string_view field);

/// Adds an option, and the name that it had before. What is at its place is the default that the
/// help shows.
void add_option(CommandLine& line, const OptionFacts& facts, OptionPlace place);

}  // namespace pliant::app
