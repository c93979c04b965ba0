// SPDX-License-Identifier: MIT
#include "pliant/base/system/terminal.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>

namespace pliant {

bool is_stderr_a_terminal() { return ::_isatty(::_fileno(stderr)) != 0; }

/// Lines end as they do on every other system, so that tables and scripts are the same bytes.
void prepare_terminal() {
  ::SetConsoleOutputCP(CP_UTF8);
  const HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (::GetConsoleMode(console, &mode))
    ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  ::_setmode(::_fileno(stdout), _O_BINARY);
  ::_setmode(::_fileno(stderr), _O_BINARY);
}

}  // namespace pliant
