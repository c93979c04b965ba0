// SPDX-License-Identifier: MIT
// The time-independent part of an H5MD file of the session.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// What `pliant run --forces` would record for the session: `parameters` as rows of path, type and
/// value, and the texts and numbers of `topology` by name.
Reply recorded(const Request& request);

}  // namespace pliant::play
