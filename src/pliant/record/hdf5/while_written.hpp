// SPDX-License-Identifier: MIT
// Reading a file that somebody may be writing: tried again, until it is said who is in the way.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>

#include "pliant/base/error.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// Whether somebody has written to the file in the last seconds.
bool is_new(const std::filesystem::path& path);

/// Returns what `read` returns. While the file is being written, a failure may come from a commit
/// that is half done: after a FileError, or an InputError that speaks of damage, `read` is then
/// called again, for two seconds.
/// Throws what `read` threw last, with the file's name before it; FileError "is being written by
/// ..." where the writer is still at it.
template <class Read>
auto while_written(const std::filesystem::path& path, const Read& read) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds patience{2000}, pause{20};
  const Clock::time_point deadline = Clock::now() + patience;
  const std::string name = path.string() + ": ";
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
