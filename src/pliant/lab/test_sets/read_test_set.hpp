// SPDX-License-Identifier: MIT
// Reads test sets that make_test_set.hpp or other programs wrote.
#pragma once

#include <filesystem>

#include "pliant/lab/test_sets/test_set.hpp"

namespace pliant {

/// Reads results.xml and every graph, ordering and force file that it names. Throws InputError
/// naming file, line, what was expected and found, also for anything missing, of another class, or
/// with other settings. Throws FileError.
TestSet read_test_set(const std::filesystem::path& directory);

}  // namespace pliant
