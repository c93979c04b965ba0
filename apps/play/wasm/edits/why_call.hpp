// SPDX-License-Identifier: MIT
// The call that says what holds a pull.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Answers for a `joint` that is drawn to `target` by `share` of the way, at most `furthest`
/// Angstrom a step: `said`, one sentence or more, and `lines`, each with what holds, its joints and
/// whether it can be cut. Nothing changes.
Reply why(const Request& request);

}  // namespace pliant::play
