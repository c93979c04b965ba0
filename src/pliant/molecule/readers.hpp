// SPDX-License-Identifier: MIT
// The reader of each format: the functions that the table of formats is made of. Text that comes
// here has passed check_text(): it has no byte order mark and no binary bytes.
#pragma once

#include "pliant/molecule/read.hpp"

namespace pliant {

bool looks_like_pdb(std::string_view text);
bool looks_like_mmcif(std::string_view text);
bool looks_like_xyz(std::string_view text);
bool looks_like_sdf(std::string_view text);

Structure read_pdb(const SourceText& source, const ReadOptions& options);
Structure read_mmcif(const SourceText& source, const ReadOptions& options);
Structure read_xyz(const SourceText& source, const ReadOptions& options);
Structure read_sdf(const SourceText& source, const ReadOptions& options);

}  // namespace pliant
