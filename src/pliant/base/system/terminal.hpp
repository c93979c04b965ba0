// SPDX-License-Identifier: MIT
// The terminal, if there is one.
#pragma once

namespace pliant {

/// Whether messages (stderr) go to a terminal.
bool is_stderr_a_terminal();

/// Lets the terminal show UTF-8 and obey escape sequences; most do without being asked.
void prepare_terminal();

}  // namespace pliant
