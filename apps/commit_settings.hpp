// SPDX-License-Identifier: MIT
// Where and how often a run in one file, or a sample, commits what it has done.
#pragma once

#include <string>

#include "command_line.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant::app {

/// See CommitLog.
struct CommitSettings {
  std::string file;       ///< "": nowhere
  double seconds = 10.0;  ///< between commits; 0: after each step or frame
};

void add_commit_options(CommandLine& line, CommitSettings& settings);
/// Throws OptionError where there is an interval but no file, or where the output is continued.
void check_commits(const CommandLine& line, const CommitSettings& settings);

/// The output is then written in one go; where there are commits, what is there of it is replaced.
void go_on_from_commits(const CommitSettings& settings, H5mdOptions& record);

}  // namespace pliant::app
