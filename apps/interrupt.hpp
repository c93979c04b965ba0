// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and SIGHUP (the terminal is closed): the first asks to stop, so that the output
// is left whole; a second ends the program at once.
#pragma once

namespace pliant::app {

void watch_for_interrupt();
bool interrupted();

}  // namespace pliant::app
