// SPDX-License-Identifier: MIT
// The settings of a recorded run, and options that are given again when it continues.
#pragma once

#include <vector>

#include "command_line.hpp"
#include "options/run_settings.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::app {

/// Throws OptionError for the first option of the command line that contradicts the file, or that
/// makes no sense when a run continues.
void check_options_again(const CommandLine& line, const RunSettings& given,
                         const H5mdCheckpoint& recorded);

/// The options with which the run continues. Throws InputError if the file lacks them.
RunOptions options_of(const H5mdCheckpoint& recorded);

}  // namespace pliant::app
