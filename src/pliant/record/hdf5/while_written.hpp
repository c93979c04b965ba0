// SPDX-License-Identifier: MIT
// Reading a file that another process may be writing: repeated for a while, then an error that
// names the writer.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// Whether the file was written within the last seconds.
bool is_new(const std::filesystem::path& path);

/// Returns what `read` returns. While the file is being written, an unfinished commit can make it
/// fail: after a FileError, or an InputError about damage, `read` is called again for up to two
/// seconds. Throws the last error of `read`, with the file's name before it; FileError "is being
/// written by ..." if the writer is still active.
template <class Read>
auto while_written(const std::filesystem::path& path, const Read& read) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds patience{2000}, pause{20};
  const Clock::time_point deadline = Clock::now() + patience;
  const std::string name = path_text(path) + ": ";
  for (bool is_last = false;; std::this_thread::sleep_for(pause)) {
    const auto fail = [&]<class Failure>(const Failure& error, bool may_pass) {
      const std::string writer = writer_of(path);
      if (is_last || !may_pass || (writer.empty() && !is_new(path)))
        throw Failure(name + error.what());
      if (writer.empty()) {
        is_last = true;  // it may have ended just now: once more
      } else if (Clock::now() > deadline) {
        throw FileError(name + "is being written by " + writer + " (" + error.what() + ")");
      }
    };
    try {
      return read();
    } catch (const InputError& error) {
      fail(error, std::string_view(error.what()).find("damaged") != std::string_view::npos);
    } catch (const FileError& error) {
      fail(error, true);
    }
  }
}

}  // namespace pliant
