// SPDX-License-Identifier: MIT
// Calls that list choices, and open a document.
#pragma once

#include "call.hpp"

namespace pliant::play {

Reply boot(const Request& request);
Reply open(const Request& request);
Reply example(const Request& request);
Reply structgen(const Request& request);

}  // namespace pliant::play
