// SPDX-License-Identifier: MIT
// What the process writes to one watched file: the system calls can be kept, for replay up to any
// of them, or made to fail. write_calls.cpp puts itself before the C library's pwrite and
// ftruncate, so that the tested code needs no hook.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
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

/// Applies writes to a file as the kernel does, which a kill can stop between pages. It uses calls
/// that are not watched.
class WriteReplay {
 public:
  explicit WriteReplay(const std::filesystem::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDWR | O_CREAT, 0600)) {}
  ~WriteReplay() { ::close(descriptor_); }

  template <class Look>
  void apply(const WriteCall& call, Look look_at_torn_state) {
    if (call.truncates) {
      std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(call.offset));
      return;
    }
    std::size_t done = 0;
    while (done < call.bytes.size()) {
      if (done > 0) look_at_torn_state();
      constexpr std::size_t page = 4096;
      const std::size_t to_page = page - (static_cast<std::size_t>(call.offset) + done) % page;
      const std::size_t count = std::min(to_page, call.bytes.size() - done);
      const iovec part{const_cast<std::byte*>(call.bytes.data() + done), count};
      ASSERT_EQ(::pwritev(descriptor_, &part, 1, call.offset + static_cast<off_t>(done)),
                static_cast<ssize_t>(count));
      done += count;
    }
  }

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace pliant::test
