// SPDX-License-Identifier: MIT
// What the process writes to one watched file: the system calls can be kept, for replay up to any
// of them, or made to fail. write_calls.cpp puts itself before the C library's pwrite and
// ftruncate, so that the tested code needs no hook.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace pliant::test {

/// One pwrite, or one ftruncate (no bytes).
struct WriteCall {
  off_t offset = 0;  ///< for ftruncate, the new size
  std::vector<std::byte> bytes;
  bool truncates = false;
};

/// While it lives, calls on files of this process are watched. At most one may live.
class WriteWatch {
 public:
  WriteWatch();
  ~WriteWatch();
  WriteWatch(const WriteWatch&) = delete;
  WriteWatch& operator=(const WriteWatch&) = delete;

  bool keep = false;  ///< keep the calls in `calls`
  long fail_at = -1;  ///< the call with this number (from 0), and all later ones, fail ...
  int error = 0;      ///< ... with this errno
  bool half = false;  ///< the first failing write writes half of its bytes before
  long count = 0;     ///< calls so far
  std::vector<WriteCall> calls;
};

/// While it lives, file systems have no locks (flock), as some network ones.
struct NoLocks {
  explicit NoLocks(int why) { error = why; }
  ~NoLocks() { error = 0; }
  static inline int error = 0;
};

}  // namespace pliant::test
