// SPDX-License-Identifier: MIT
// What an H5MD file of the session says besides its frames.
#pragma once

#include "call.hpp"

namespace pliant::play {

/// As `pliant run --forces` records the session: `parameters` as rows of path, type and value, the
/// texts and numbers of `topology` by name.
Reply recorded(const Request& request);

}  // namespace pliant::play
