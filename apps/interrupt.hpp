// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and SIGHUP (the terminal is closed): the first one asks to stop, which leaves
// complete output; a second one ends the program at once.
#pragma once

namespace pliant::app {

void watch_for_interrupt();
bool interrupted();

}  // namespace pliant::app
