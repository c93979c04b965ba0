// SPDX-License-Identifier: MIT
// A subcommand of pliant: one row of the table in commands.cpp, one commands/cmd_*.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pliant::app {

/// Exit codes of subcommands.
enum ExitCode {
  exit_ok = 0,
  exit_failed = 1,        ///< bad input, a file that cannot be read or written
  exit_usage = 2,         ///< bad option or argument
  exit_unconverged = 3,   ///< the work was done, but some step did not converge
  exit_interrupted = 130  ///< ended early by Ctrl-C; output is complete up to there
};

using Arguments = std::vector<std::string>;

struct Command {
  std::string_view group;  ///< heading under which the help lists the row
  std::string_view name;
  std::string_view summary;
  int (*run)(const Arguments& arguments);  ///< null: a separate program pliant-NAME
};

int command_contacts(const Arguments& arguments);
int command_forcegen(const Arguments& arguments);
int command_info(const Arguments& arguments);
int command_lab(const Arguments& arguments);
int command_order(const Arguments& arguments);
int command_rigidity(const Arguments& arguments);
int command_run(const Arguments& arguments);
int command_sample(const Arguments& arguments);
int command_structgen(const Arguments& arguments);
int command_techniques(const Arguments& arguments);

}  // namespace pliant::app
