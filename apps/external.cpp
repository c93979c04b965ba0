// SPDX-License-Identifier: MIT
#include "external.hpp"

#include <cerrno>
#include <cstdio>
#include <optional>

#include "pliant/base/error.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/process.hpp"
#include "pliant/base/system/program_folders.hpp"
#include "pliant/base/system/signals.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

fs::path own_path;  // empty: that of the executable

/// Empty where the system does not say.
fs::path own_folder() { return (own_path.empty() ? own_program() : own_path).parent_path(); }

[[noreturn]] void fail_to_run(const fs::path& path) {
  throw FileError(path_text(path) + ": cannot be run: " + error_words(errno));
}

}  // namespace

void set_own_path(const fs::path& path) { own_path = path; }

fs::path find_external(const std::string& name) {
  if (name.find_first_of("/\\") != std::string::npos) return "";
  const fs::path file = path_of(program_file("pliant-" + name));
  const fs::path beside = own_folder();
  if (!beside.empty() && is_program(beside / file)) return beside / file;
  for (const fs::path& folder : program_folders())
    if (is_program(folder / file)) return folder / file;
  return "";
}

int run_with_input(const fs::path& path, const Arguments& arguments, const std::string& input) {
  const std::optional<int> code = run_program_with_input(path, arguments, input);
  if (!code) fail_to_run(path);
  return *code < 0 ? int{exit_failed} : *code;
}

int run_program(const std::string& name, const Arguments& arguments) {
  const fs::path path = find_external(name);
  if (path.empty()) {
    std::fprintf(stderr,
                 "pliant: %s is part of the Python package: install it (pip install pliant), "
                 "so that pliant-%s is on PATH\n",
                 name.c_str(), name.c_str());
    return exit_failed;
  }
  std::fflush(nullptr);
  // It answers each of them with an exit code of its own, once Python has started.
  if (name == "ensemble") hold_requests_to_end();
  // NumPy's own threads wait for each other by counting: matrices of some hundred rows take three
  // times the CPU time on two of them, and no less time.
  set_if_unset("OPENBLAS_NUM_THREADS", "1");
  become_program(path, arguments);
  fail_to_run(path);
}

}  // namespace pliant::app
