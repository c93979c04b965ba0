// SPDX-License-Identifier: MIT
// What the system interrupts a process with.
#pragma once

#include <cstdint>

namespace pliant {

/// A write beyond the limit of file sizes (RLIMIT_FSIZE) raises SIGXFSZ, which kills the process.
/// As long as this object lives, such a signal of its thread waits, and is taken away at the end:
/// the write fails alone. Does nothing where there is no such signal.
class FileSizeSignalHeld {
 public:
  FileSizeSignalHeld();
  ~FileSizeSignalHeld();
  FileSizeSignalHeld(const FileSizeSignalHeld&) = delete;
  FileSizeSignalHeld& operator=(const FileSizeSignalHeld&) = delete;

 private:
  bool was_held_ = true;
};

/// From now on a closed pipe or a full quota is an error of the write that meets it, not the end of
/// the process.
void fail_writes_alone();

/// How a process is asked to end.
enum class RequestToEnd : std::uint8_t {
  pressed,        ///< by Ctrl-C, SIGTERM, or the end of the terminal
  ahead_of_time,  ///< by a queue before the time is up (SIGUSR1): once or often, alone or with
                  ///< SIGTERM
};

/// Calls `ask` whenever the user or the system asks the process to end. Requests that whoever
/// started the process has ignored stay ignored. `ask` may do only what a signal handler may.
void call_on_request_to_end(void (*ask)(RequestToEnd));

/// Holds back Ctrl-C, SIGTERM, SIGHUP and SIGUSR1 until the program that this process becomes takes
/// them (become_program()). Windows has none of them.
void hold_requests_to_end();

}  // namespace pliant
