// SPDX-License-Identifier: MIT
// pliant run --forces: the pushes or events of a force file, and the options allowed with them.
#pragma once

#include "options/run_settings.hpp"

namespace pliant::app {

/// Applies the force file that take_force_header() has read to the settings. It decides only what
/// the command line leaves open. Throws InputError as the parsers do, and OptionError for options
/// that contradict it.
void take_forces(const CommandLine& line, RunSettings& settings, const Molecule& molecule);

}  // namespace pliant::app
