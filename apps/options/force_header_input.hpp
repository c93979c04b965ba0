// SPDX-License-Identifier: MIT
// pliant run --forces: what the force file was made for, beside what the command line says.
#pragma once

#include "options/run_settings.hpp"
#include "pliant/base/log.hpp"

namespace pliant::app {

/// Reads the force file, and takes those options of the molecule from its header that the command
/// line leaves open. Throws OptionError where both say different things, unless --override-forces
/// was given, and InputError as read_force_header() does.
void take_force_header(const CommandLine& line, RunSettings& settings);

/// Throws InputError if the file was made for another structure or framework; with
/// --override-forces that is a warning. Warns where a file does not say what it was made for.
void check_force_header(const RunSettings& settings, const Molecule& molecule, const Log& log);

/// Whether an option of the command line holds in place of `made`, what the force file says (such
/// as "with --model protein"). Throws OptionError unless --override-forces was given.
bool overrides_forces(const RunSettings& settings, const std::string& given,
                      const std::string& made);

}  // namespace pliant::app
