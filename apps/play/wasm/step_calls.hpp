// SPDX-License-Identifier: MIT
// Calls that make steps of the session.
#pragma once

#include "call.hpp"

namespace pliant::play {

Reply pull(const Request& request);
Reply resolution(const Request& request);
Reply wander(const Request& request);
Reply forces(const Request& request);
Reply again(const Request& request);
Reply undo(const Request& request);
Reply state(const Request& request);
Reply settings(const Request& request);
Reply step_limit(const Request& request);

}  // namespace pliant::play
