// SPDX-License-Identifier: MIT
// The call that selects joints by words.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Joints that `text` selects, in the language of `pliant run --select`.
Reply select_joints_of(const Request& request);

}  // namespace pliant::play
