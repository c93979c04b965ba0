// SPDX-License-Identifier: MIT
// Calls that find a path to another structure of what is open.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Reads the other structure and begins a session at the start of the path.
Reply begin_path(const Request& request);
/// Goes on with it for so many milliseconds, at least one step.
Reply path_steps(const Request& request);

}  // namespace pliant::play
