// SPDX-License-Identifier: MIT
// Calls that find a path from the open molecule to another structure of it.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Reads the other structure and begins a session at the start of the path.
Reply begin_path(const Request& request);
/// Continues it for some milliseconds, at least one step.
Reply path_steps(const Request& request);

}  // namespace pliant::play
