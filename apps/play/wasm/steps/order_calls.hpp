// SPDX-License-Identifier: MIT
// Calls about the order in which sweeps visit bars.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Reads an ordering file (the thesis' constraint file); technique `input` visits the bars by it.
Reply ordering_file(const Request& request);
/// The first sweep of a `technique` that is an ordering, from joint `root`: `visits` (4 V) bar,
/// near joint, far joint, 1 for a tree bar; `text`: the same as an ordering file.
Reply ordering(const Request& request);

}  // namespace pliant::play
