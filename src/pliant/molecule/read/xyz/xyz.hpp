// SPDX-License-Identifier: MIT
// Reads XYZ and extended XYZ. The text must have passed check_text(): it has no byte order mark and
// no binary bytes. Internal: users call read.hpp.
#pragma once

#include <string_view>

#include "pliant/molecule/read/shared/read_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

bool looks_like_xyz(std::string_view text);
Structure read_xyz(const SourceText& source, const ReadOptions& options);

}  // namespace pliant
