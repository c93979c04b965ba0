// SPDX-License-Identifier: MIT
// pliant run --forces: the pushes or events of a force file, and the options allowed with them.
#pragma once

#include "pliant/jobs/replayed_header.hpp"

namespace pliant {

/// Applies the force file that take_force_header() has read to the job. It decides only what is
/// not given. Throws InputError as the parsers do, and OptionError for options
/// that contradict it.
void take_forces(Job& job, ReplayedForces& replayed, const RunSubject& subject);

}  // namespace pliant
