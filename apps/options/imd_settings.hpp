// SPDX-License-Identifier: MIT
// The options of pliant run for programs that follow it and pull (IMD), and their server.
#pragma once

#include <memory>
#include <string>

#include "command_line.hpp"
#include "pliant/jobs/run_watch.hpp"
#include "pliant/stream/imd_server.hpp"

namespace pliant::app {

struct ImdSettings {
  bool is_asked = false;
  std::string address;  ///< "PORT", "HOST:PORT"; "": the port that is usual
  std::string host = "127.0.0.1";
  std::int64_t port = 8888;
  std::int64_t version = 3;
  bool wait = false;
};

void add_imd_options(CommandLine& line, ImdSettings& settings);

/// Takes host and port from the address. Throws OptionError for one that is none, and for options
/// of a server where none is asked for.
void settle_imd(const CommandLine& line, ImdSettings& settings);

/// A run that clients follow and pull on.
class LiveRun {
 public:
  /// Starts listening. Throws FileError if it cannot. The log must outlive it.
  LiveRun(const ImdSettings& settings, const RunOptions& run, std::size_t joint_count,
          const Log& log);

  Onlooker onlooker();
  std::vector<std::shared_ptr<Pusher>> hands() const { return {steering_}; }
  bool was_killed() const { return server_.was_killed(); }
  /// Prints on stderr where the run can be followed.
  void say_where(const std::string& topology) const;
  /// Says that no more frames come, so that clients can end while files are still being written.
  void finish() { server_.finish(); }
  /// Whether clients have pulled.
  bool was_pulled() { return server_.summary().forces_taken > 0; }
  /// Waits until the clients have read what is left.
  ImdSummary close() { return server_.close(); }

 private:
  ImdSettings settings_;
  std::shared_ptr<Steering> steering_;
  ImdServer server_;
};

}  // namespace pliant::app
