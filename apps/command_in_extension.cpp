// SPDX-License-Identifier: MIT
// The command of a wheel lies in the extension pliant._core, so that a wheel has the library once.
// The script `pliant` (python/wheel/command.py) calls it, with its own path and words in UTF-8.
#include "commands.hpp"
#include "external.hpp"
#include "pliant/base/system/path_text.hpp"

// How a library shows a name: python/CMakeLists.txt says it where the system wants another word.
#ifndef PLIANT_SHOWN
#define PLIANT_SHOWN gnu::visibility("default")
#endif

extern "C" [[PLIANT_SHOWN]] int pliant_command(int argc, char** argv) {
  pliant::app::set_own_path(pliant::path_of(argv[0]));
  return pliant::app::run_command({argv + 1, argv + argc});
}
