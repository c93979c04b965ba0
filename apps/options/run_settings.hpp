// SPDX-License-Identifier: MIT
// The job of pliant run, and what comes with its command line besides.
#pragma once

#include "options/imd_settings.hpp"
#include "options/job_options.hpp"

namespace pliant::app {

struct RunSettings {
  Job job = usual_job("run");
  Printing printing;
  ImdSettings imd;
};

}  // namespace pliant::app
