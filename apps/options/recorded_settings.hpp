// SPDX-License-Identifier: MIT
// The settings of a recorded run, and options that are given once more when it goes on.
#pragma once

#include <vector>

#include "command_line.hpp"
#include "options/run_settings.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::app {

/// Throws OptionError at the first option of the command line that the file does not agree with, or
/// that makes no sense when a run goes on.
void check_options_again(const CommandLine& line, const RunSettings& given,
                         const H5mdCheckpoint& recorded);

/// How the run goes on. Throws InputError where the file does not say it.
RunOptions options_of(const H5mdCheckpoint& recorded);

}  // namespace pliant::app
