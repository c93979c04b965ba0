// SPDX-License-Identifier: MIT
// Paths as UTF-8 text, on every system. Windows keeps paths in UTF-16, and its narrow text has the
// code page of the machine: only these functions go from one to the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// Returns the path as UTF-8; on POSIX, its bytes as they are.
std::string path_text(const std::filesystem::path& path);

/// Returns the path of UTF-8 text; on POSIX, of any bytes.
std::filesystem::path path_of(std::string_view text);

/// Returns the words of the command line after the first, as UTF-8. Where the system gives `argv`
/// so, they are taken from there.
std::vector<std::string> command_words(int argc, char** argv);

/// Returns an environment variable as UTF-8; "" if it is not set.
std::string environment(const char* name);

}  // namespace pliant
