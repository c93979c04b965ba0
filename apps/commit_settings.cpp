// SPDX-License-Identifier: MIT
#include "commit_settings.hpp"

#include <filesystem>
#include <limits>
#include <system_error>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {

void add_commit_options(CommandLine& line, CommitSettings& settings) {
  line.add_text("--commits", settings.file, "FILE",
                "save finished work here until the output is complete; after a kill the same\n"
                "command continues from it, and the output has the same bytes");
  line.add_real("--commit-seconds", settings.seconds, Range::zero_or_more,
                "interval between commits (s)");
}

void check_commits(const CommandLine& line, const CommitSettings& settings) {
  if (line.was_given("--commit-seconds") && settings.file.empty())
    throw OptionError("--commit-seconds: goes with --commits");
  if (line.was_given("--continue") && !settings.file.empty())
    throw OptionError("--commits: does not go with --continue: give the command of the beginning");
}

void go_on_from_commits(const CommitSettings& settings, H5mdOptions& record) {
  if (settings.file.empty()) return;
  record.flush_seconds = std::numeric_limits<double>::infinity();
  std::error_code error;
  if (std::filesystem::exists(path_of(settings.file), error)) record.overwrite = true;
}

}  // namespace pliant::app
