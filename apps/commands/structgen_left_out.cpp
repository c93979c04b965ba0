// SPDX-License-Identifier: MIT
// In the place of cmd_structgen.cpp, where the laboratory is left out of a build.
#include <cstdio>

#include "command.hpp"

namespace pliant::app {

int command_structgen(const Arguments&) {
  std::fputs(
      "pliant structgen: error: needs the laboratory, which this build leaves out: build with "
      "-DPLIANT_LABORATORY=ON, or pip install --force-reinstall --no-deps pliant\n",
      stderr);
  return exit_failed;
}

}  // namespace pliant::app
