// SPDX-License-Identifier: MIT
// What a kill leaves behind: kept writes, applied up to any page of any of them.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "unit/record/write_calls.hpp"

namespace pliant::test {

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
