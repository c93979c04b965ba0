// SPDX-License-Identifier: MIT
#include "pliant/base/system/path_text.hpp"

#include <cstdlib>

namespace pliant {

std::string path_text(const std::filesystem::path& path) { return path.native(); }

std::filesystem::path path_of(std::string_view text) { return text; }

std::vector<std::string> command_words(int argc, char** argv) {
  return argc > 0 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>();
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace pliant
