// SPDX-License-Identifier: MIT
// The call that samples.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// Makes frames of `pliant sample` about the start of the open document. The request names rows of
/// sample_fields().
Reply sample_frames(const Request& request);

}  // namespace pliant::play
