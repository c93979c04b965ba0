// SPDX-License-Identifier: MIT
// pliant run --forces with a file of events: options that are allowed with it, and its settings.
#pragma once

#include "pliant/jobs/replayed_header.hpp"

namespace pliant {

/// Parses the events of the force file that was read. The settings of the last step become those
/// that are recorded. Throws OptionError for options that contradict it.
void take_events(Job& job, ReplayedForces& replayed, const RunSubject& subject);

}  // namespace pliant
