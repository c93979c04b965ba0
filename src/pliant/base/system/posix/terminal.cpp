// SPDX-License-Identifier: MIT
#include "pliant/base/system/terminal.hpp"

#include <unistd.h>

namespace pliant {

bool is_stderr_a_terminal() { return ::isatty(STDERR_FILENO) == 1; }

void prepare_terminal() {}

}  // namespace pliant
