// SPDX-License-Identifier: MIT
#include "commands/show_sample.hpp"

#include <cstdio>

#include "external.hpp"
#include "interrupt.hpp"
#include "output/frame_output.hpp"
#include "pliant/base/error.hpp"

namespace pliant::app {

void check_show(const SampleSettings& settings) {
  if (settings.show && (is_pdb_name(settings.output) || is_sdf_name(settings.output)))
    throw OptionError("--show: expected an H5MD output, which holds all that the page shows");
}

int shown(const SampleSettings& settings, int code) {
  if (!settings.show || interrupted()) return code;
  std::fflush(nullptr);  // what was printed is not of the next program
  return run_program("play", {settings.output});
}

}  // namespace pliant::app
