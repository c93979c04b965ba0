// SPDX-License-Identifier: MIT
// Undoing bzip2, with libbz2.
#pragma once

#include <memory>

#include "pliant/text/decoder.hpp"

namespace pliant {

/// Null where this build has no libbz2. Throws std::bad_alloc.
std::unique_ptr<Decoder> make_bzip2_decoder();

}  // namespace pliant
