// SPDX-License-Identifier: MIT
// Messages of the command besides its result: notes, warnings and a progress bar, all on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "pliant/base/log.hpp"

namespace pliant::app {

/// Keeps the library's messages, and prints them at once unless quiet.
class Messages {
 public:
  explicit Messages(bool quiet) : quiet_(quiet) {}
  Log log();
  /// The same for reading and preparing `file`, without details, and of warnings on lines of the
  /// file with the first alone. With `verbose` all are printed.
  Log log_of_model(const std::string& file, bool verbose);
  /// Says what a model has left out, and how many warnings on lines were not printed.
  void end_model(const std::vector<std::string>& left_out);
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void say(Severity severity, std::string_view text) const;

  bool quiet_;
  bool is_brief_ = false;
  std::size_t on_lines_ = 0;  ///< warnings on lines of the file
  std::vector<std::string> notes_, warnings_;
};

/// Adds the option of commands that print little without it.
void add_verbose(CommandLine& line, bool& verbose);

/// "[#####-----] 512 / 1000 steps, 3 s left", redrawn in place. Only on a terminal, and only after
/// a second.
class ProgressBar {
 public:
  ProgressBar(std::int64_t total, std::string unit, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(std::int64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::int64_t done, double seconds);

  std::int64_t total_;
  std::string unit_;
  bool enabled_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace pliant::app
