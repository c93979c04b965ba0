// SPDX-License-Identifier: MIT
// Calls that change what holds: cuts, bars, freed angles and torsions.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Makes edits [[word, a, b], ...]: "cut", "bar" (and a length, else the present distance),
/// "restore", and "turn": cuts all bars that keep a bond from turning. Replies as edited().
Reply edit(const Request& request);
/// The reply of `open` for what there is after all edits, and `changes` in words.
Reply edited(const Request& request);
/// What joins two joints, how far apart they are, and what may be done about it.
Reply pair(const Request& request);

}  // namespace pliant::play
