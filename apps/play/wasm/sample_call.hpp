// SPDX-License-Identifier: MIT
// The call that samples.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Frames [first, first + frames) of `pliant sample` about the start of what is open.
Reply sample_frames(const Request& request);

}  // namespace pliant::play
