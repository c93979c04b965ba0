// SPDX-License-Identifier: MIT
// Calls that open a force file and repeat it on the open session.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// What the header of a force file says, for a page that has to open the right model first.
Reply force_file(const Request& request);
/// Reads a force file for the session, which has made no step: its events as rows of a list. With
/// `technique` and `weighting` the file's own have no say.
Reply begin_replay(const Request& request);
/// Steps of it, at least one, for so many `milliseconds`, at most `most`; the twin, if there is
/// one, makes them too.
Reply replay_steps(const Request& request);

}  // namespace pliant::play
