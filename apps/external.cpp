// SPDX-License-Identifier: MIT
#include "external.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

std::string_view search_path() {
  const char* path = std::getenv("PATH");
  return path == nullptr ? "" : path;
}

}  // namespace

std::string find_external(const std::string& name) {
  if (name.find('/') != std::string::npos) return "";
  const std::string file = "pliant-" + name;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (!error && is_program(self.parent_path() / file)) return self.parent_path() / file;
  std::string_view rest = search_path();
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path folder = rest.substr(0, colon);
    if (!folder.empty() && is_program(folder / file)) return folder / file;
    rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
  }
  return "";
}

void become(const std::string& path, const Arguments& arguments) {
  std::vector<char*> raw{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  execv(path.c_str(), raw.data());
}

}  // namespace pliant::app
