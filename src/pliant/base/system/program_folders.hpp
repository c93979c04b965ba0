// SPDX-License-Identifier: MIT
// Where programs are.
#pragma once

#include <filesystem>
#include <vector>

namespace pliant {

/// Returns the folders in which a shell looks for programs (PATH).
std::vector<std::filesystem::path> program_folders();

}  // namespace pliant
