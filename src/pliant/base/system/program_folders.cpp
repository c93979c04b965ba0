// SPDX-License-Identifier: MIT
#include "pliant/base/system/program_folders.hpp"

#include <string>
#include <string_view>

#include "pliant/base/system/path_text.hpp"

namespace pliant {

std::vector<std::filesystem::path> program_folders() {
  // Windows has colons in paths.
  constexpr char between = std::filesystem::path::preferred_separator == '/' ? ':' : ';';
  std::vector<std::filesystem::path> folders;
  const std::string path = environment("PATH");
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::size_t end = rest.find(between);
    if (end != 0) folders.push_back(path_of(rest.substr(0, end)));
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return folders;
}

}  // namespace pliant
