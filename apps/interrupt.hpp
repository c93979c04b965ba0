// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and SIGHUP (the terminal is closed): the first one asks to stop, which leaves
// complete output; a second one ends the program at once. SIGUSR1 asks to stop, and no more than
// that however often it comes.
#pragma once

namespace pliant::app {

void watch_for_interrupt();
bool interrupted();

}  // namespace pliant::app
