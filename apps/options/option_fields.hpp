// SPDX-License-Identifier: MIT
// Makes options of the command line from rows of a table of options.
#pragma once

#include "command_line.hpp"
#include "pliant/base/option_fields.hpp"

namespace pliant::app {

/// Adds an option. Its present value is the default that the help shows.
void add_option(CommandLine& line, const OptionFacts& facts, OptionPlace place);

}  // namespace pliant::app
