// SPDX-License-Identifier: MIT
// What the system interrupts a process with.
#pragma once

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

/// Calls `ask` whenever the user or the system asks the process to end: Ctrl-C, SIGTERM, a closed
/// terminal. Requests that whoever started the process has ignored stay ignored. `ask` may do only
/// what a signal handler may.
void call_on_request_to_end(void (*ask)());

}  // namespace pliant
