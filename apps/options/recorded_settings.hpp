// SPDX-License-Identifier: MIT
// Options that are given once more when a run goes on, beside those of its file.
#pragma once

#include "command_line.hpp"
#include "options/run_settings.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::app {

/// Throws OptionError for the first option of the command line that contradicts the file, or that
/// makes no sense when a run continues.
void check_options_again(const CommandLine& line, const RunSettings& given,
                         const H5mdCheckpoint& recorded);

}  // namespace pliant::app
