// SPDX-License-Identifier: MIT
// pliant run --forces: the pushes or events of a force file, and which options go with them.
#pragma once

#include "options/run_settings.hpp"

namespace pliant::app {

/// What the force file that take_force_header() has read means to a run. Its settings hold where
/// the command line is silent. Throws InputError as the parsers do, and OptionError for options
/// that contradict it.
void take_forces(const CommandLine& line, RunSettings& settings, const Molecule& molecule);

}  // namespace pliant::app
