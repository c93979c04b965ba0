// SPDX-License-Identifier: MIT
// pliant run --forces: compares what the force file was made for with the command line.
#pragma once

#include "options/run_settings.hpp"
#include "pliant/base/log.hpp"

namespace pliant::app {

/// Reads the force file, and takes from its header the options of the molecule that the command
/// line leaves open. Throws OptionError if both differ, unless --override-forces was given, and
/// InputError as read_force_header() does.
void take_force_header(const CommandLine& line, RunSettings& settings);

/// Throws InputError if the file was made for another structure or framework; a warning with
/// --override-forces. Warns if a file does not say what it was made for.
void check_force_header(const RunSettings& settings, const Molecule& molecule, const Log& log);

/// Whether an option of the command line overrides `made`, that of the force file (such as "with
/// --model protein"). Throws OptionError unless --override-forces was given.
bool overrides_forces(const RunSettings& settings, const std::string& given,
                      const std::string& made);

}  // namespace pliant::app
