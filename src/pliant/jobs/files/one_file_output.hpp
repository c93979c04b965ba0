// SPDX-License-Identifier: MIT
// Writes several walkers into one trajectory, one after another, although they run at once.
#pragma once

#include <cstdint>
#include <map>

#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/jobs/files/kept_frames.hpp"

namespace pliant {

/// Writes walkers in the order of their numbers, so that the same run gives the same file with any
/// number of threads. Calls must not overlap.
class OneFileOutput {
 public:
  OneFileOutput(FrameOutput output, std::int64_t first)
      : output_(std::move(output)), next_(first) {}

  /// Notes that the walker has ended. Throws as recorders do.
  void end(std::int64_t walker, KeptFrames frames);
  void close() { output_.close(); }

 private:
  void write(const KeptFrames& frames);

  FrameOutput output_;
  std::int64_t next_;  ///< the next walker to be written
  std::map<std::int64_t, KeptFrames> waiting_;
};

}  // namespace pliant
