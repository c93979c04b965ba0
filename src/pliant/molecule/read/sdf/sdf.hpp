// SPDX-License-Identifier: MIT
// Reads MDL molfiles and SDF, V2000 and V3000. The text must have passed check_text(): it has no
// byte order mark and no binary bytes. Internal: users call read.hpp.
#pragma once

#include <string_view>

#include "pliant/molecule/read/shared/read_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

bool looks_like_sdf(std::string_view text);
Structure read_sdf(const SourceText& source, const ReadOptions& options);

}  // namespace pliant
