// SPDX-License-Identifier: MIT
#include "pliant/base/system/process.hpp"

#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <span>
#include <system_error>

#include "pliant/base/system/descriptor.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// HDF5 frees links that it did not get to read, of a list that is not initialized
/// (H5G__dense_iterate, 1.10): what is there must crash in the copy, not by chance later.
void fill_new_memory() {
#if defined(__GLIBC__)
  ::mallopt(M_PERTURB, 0x5a);
#endif
}

/// Runs in the copy that may crash, and never returns.
[[noreturn]] void crash_or_end(const std::function<void()>& task, unsigned most_seconds) {
  const rlimit none{0, 0}, time{most_seconds, most_seconds};
  ::setrlimit(RLIMIT_CORE, &none);
  ::setrlimit(RLIMIT_CPU, &time);
  for (const int crash : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU})
    ::signal(crash, SIG_DFL);
  fill_new_memory();
  task();
  ::_exit(0);
}

/// Writes as far as the reader takes it: one that ends early says why itself.
void feed(int descriptor, std::string_view input) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  static_cast<void>(write_all(descriptor, std::as_bytes(std::span(input))));
  std::signal(SIGPIPE, before);
}

/// What waitpid() says of it; nothing if it fails.
std::optional<int> status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return std::nullopt;
  return status;
}

}  // namespace

int process_id() { return ::getpid(); }

fs::path own_program() {
  std::error_code error;
#if defined(__APPLE__)
  std::array<char, 4096> name{};
  auto size = static_cast<std::uint32_t>(name.size());
  if (::_NSGetExecutablePath(name.data(), &size) != 0) return "";
  return fs::canonical(name.data(), error);
#else
  return fs::read_symlink("/proc/self/exe", error);
#endif
}

void call_around_fork(void (*before)(), void (*in_parent)(), void (*in_child)()) {
  ::pthread_atfork(before, in_parent, in_child);
}

std::optional<int> crash_in_copy(const std::function<void()>& task, unsigned most_seconds) {
  const pid_t child = ::fork();
  if (child < 0) return std::nullopt;
  if (child == 0) crash_or_end(task, most_seconds);
  const int status = status_of(child).value_or(0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

bool is_program(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

std::string program_file(const std::string& name) { return name; }

void set_if_unset(const char* variable, const char* value) { ::setenv(variable, value, 0); }

void become_program(const fs::path& program, const ProgramWords& words) {
  std::vector<char*> raw{const_cast<char*>(program.c_str())};
  for (const std::string& word : words) raw.push_back(const_cast<char*>(word.c_str()));
  raw.push_back(nullptr);
  ::execv(program.c_str(), raw.data());
}

std::optional<int> run_program_with_input(const fs::path& program, const ProgramWords& words,
                                          std::string_view input) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return std::nullopt;
  Descriptor from(ends[0]), into(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    ::dup2(from.get(), STDIN_FILENO);
    from.close();
    into.close();
    become_program(program, words);
    ::_exit(1);
  }
  from.close();
  feed(into.get(), input);
  into.close();
  const std::optional<int> status = status_of(child);
  if (!status) return std::nullopt;
  return WIFEXITED(*status) ? WEXITSTATUS(*status) : -1;
}

}  // namespace pliant
