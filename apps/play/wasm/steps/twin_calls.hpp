// SPDX-License-Identifier: MIT
// Calls of the second walker, which makes the session's steps with another technique.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Begins one with `technique` and `weighting` where the session stands; with `last` where the last
/// pull began, which it makes too: then the reply tells of it, as a film where `watched`.
Reply begin_twin(const Request& request);
/// Makes the session's last step; `watched`: with all visits to bars.
Reply twin_step(const Request& request);
Reply end_twin(const Request& request);

/// How far the two walkers are apart, joint by joint, without turning one onto the other: `apart`
/// and `aparts` (N), Angstrom.
void add_difference(Reply& reply);

}  // namespace pliant::play
