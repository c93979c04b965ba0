// SPDX-License-Identifier: MIT
// Undoing gzip (RFC 1952), with zlib.
#pragma once

#include <memory>

#include "pliant/text/decoder.hpp"

namespace pliant {

/// Null where this build has no zlib. Throws std::bad_alloc.
std::unique_ptr<Decoder> make_gzip_decoder();

}  // namespace pliant
