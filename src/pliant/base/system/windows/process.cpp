// SPDX-License-Identifier: MIT
#include "pliant/base/system/process.hpp"

#include <windows.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>

#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/windows/windows_errors_internal.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// Closed with the object.
class Handle {
 public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  ~Handle() { close(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  void close() {
    if (handle_ != nullptr) ::CloseHandle(handle_);
    handle_ = nullptr;
  }
  HANDLE get() const { return handle_; }
  HANDLE* to_fill() { return &handle_; }

 private:
  HANDLE handle_;
};

/// One word as programs take a command line apart: backslashes before a quote are doubled
/// (documentation of CommandLineToArgvW).
std::wstring quoted_word(const std::wstring& word) {
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L'"';
}

std::wstring command_line(const fs::path& program, const ProgramWords& words) {
  std::wstring line = quoted_word(program.native());
  for (const std::string& word : words) line += L" " + quoted_word(path_of(word).native());
  return line;
}

/// Starts a program with this standard input. Returns its process, or none with errno set.
HANDLE start(const fs::path& program, const ProgramWords& words, HANDLE input) {
  STARTUPINFOW how{};
  how.cb = sizeof how;
  how.dwFlags = STARTF_USESTDHANDLES;
  how.hStdInput = input;
  how.hStdOutput = ::GetStdHandle(STD_OUTPUT_HANDLE);
  how.hStdError = ::GetStdHandle(STD_ERROR_HANDLE);
  PROCESS_INFORMATION started{};
  std::wstring line = command_line(program, words);
  if (!::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr,
                        &how, &started)) {
    keep_windows_error();
    return nullptr;
  }
  ::CloseHandle(started.hThread);
  return started.hProcess;
}

int exit_code_of(HANDLE process) {
  ::WaitForSingleObject(process, INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(process, &code);
  return static_cast<int>(code);
}

/// Writes as far as the reader takes it: one that ends early says why itself.
void feed(HANDLE into, std::string_view input) {
  while (!input.empty()) {
    DWORD count = 0;
    const auto most = static_cast<DWORD>(std::min<std::size_t>(input.size(), 1 << 20));
    if (!::WriteFile(into, input.data(), most, &count, nullptr)) return;
    input.remove_prefix(count);
  }
}

}  // namespace

int process_id() { return static_cast<int>(::GetCurrentProcessId()); }

fs::path own_program() {
  std::array<wchar_t, 32768> name{};
  const DWORD size = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  return std::wstring(name.data(), size < name.size() ? size : 0);
}

void call_around_fork(void (*)(), void (*)(), void (*)()) {}

std::optional<int> crash_in_copy(const std::function<void()>&, unsigned) { return std::nullopt; }

bool is_program(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string program_file(const std::string& name) { return name + ".exe"; }

void set_if_unset(const char* variable, const char* value) {
  if (std::getenv(variable) == nullptr) ::_putenv_s(variable, value);
}

void become_program(const fs::path& program, const ProgramWords& words) {
  const Handle process(start(program, words, ::GetStdHandle(STD_INPUT_HANDLE)));
  // Ctrl-C goes to both; the other program says how it ends.
  if (process.get() == nullptr) return;
  ::SetConsoleCtrlHandler(nullptr, TRUE);
  std::_Exit(exit_code_of(process.get()));
}

std::optional<int> run_program_with_input(const fs::path& program, const ProgramWords& words,
                                          std::string_view input) {
  SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
  Handle from, into;
  if (!::CreatePipe(from.to_fill(), into.to_fill(), &inherited, 0)) {
    keep_windows_error();
    return std::nullopt;
  }
  ::SetHandleInformation(into.get(), HANDLE_FLAG_INHERIT, 0);
  const Handle process(start(program, words, from.get()));
  if (process.get() == nullptr) return std::nullopt;
  from.close();
  feed(into.get(), input);
  into.close();
  return exit_code_of(process.get());
}

}  // namespace pliant
