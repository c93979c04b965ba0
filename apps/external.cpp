// SPDX-License-Identifier: MIT
#include "external.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "pliant/base/error.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

fs::path own_path;  // empty: that of the executable

/// Empty where the system does not say.
fs::path own_folder() {
  if (!own_path.empty()) return own_path.parent_path();
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

bool is_program(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

std::string_view search_path() {
  const char* path = std::getenv("PATH");
  return path == nullptr ? "" : path;
}

[[noreturn]] void fail_to_run(const std::string& path) {
  throw FileError(path + ": cannot be run: " + std::strerror(errno));
}

/// Writes as far as the reader takes it: one that ends early says why itself.
void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

int exit_code_of(pid_t child, const std::string& path) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail_to_run(path);
  return WIFEXITED(status) ? WEXITSTATUS(status) : int{exit_failed};
}

}  // namespace

void set_own_path(const std::string& path) { own_path = path; }

std::string find_external(const std::string& name) {
  if (name.find('/') != std::string::npos) return "";
  const std::string file = "pliant-" + name;
  const fs::path beside = own_folder();
  if (!beside.empty() && is_program(beside / file)) return beside / file;
  std::string_view rest = search_path();
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path folder = rest.substr(0, colon);
    if (!folder.empty() && is_program(folder / file)) return folder / file;
    rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
  }
  return "";
}

int run_with_input(const std::string& path, const Arguments& arguments, const std::string& input) {
  std::array<int, 2> ends{};  // to read from, to write to
  if (pipe(ends.data()) != 0) fail_to_run(path);
  const pid_t child = fork();
  if (child < 0) fail_to_run(path);
  if (child == 0) {
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    close(ends[1]);
    become(path, arguments);
    _exit(exit_failed);
  }
  close(ends[0]);
  write_all(ends[1], input);
  close(ends[1]);
  return exit_code_of(child, path);
}

int run_program(const std::string& name, const Arguments& arguments) {
  const std::string path = find_external(name);
  if (path.empty()) {
    std::fprintf(stderr,
                 "pliant: %s is part of the Python package: install it (pip install pliant), "
                 "so that pliant-%s is on PATH\n",
                 name.c_str(), name.c_str());
    return exit_failed;
  }
  become(path, arguments);
  fail_to_run(path);
}

void become(const std::string& path, const Arguments& arguments) {
  std::vector<char*> raw{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  execv(path.c_str(), raw.data());
}

}  // namespace pliant::app
