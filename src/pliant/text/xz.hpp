// SPDX-License-Identifier: MIT
// Undoing xz, with liblzma.
#pragma once

#include <memory>

#include "pliant/text/decoder.hpp"

namespace pliant {

/// Null where this build has no liblzma. A file that needs more than 256 MiB to expand counts as
/// damaged (files made by `xz -9` need 65). Throws std::bad_alloc.
std::unique_ptr<Decoder> make_xz_decoder();

}  // namespace pliant
