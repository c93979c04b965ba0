// SPDX-License-Identifier: MIT
// Writes several walkers into one trajectory, one after another, although they run at once.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "output/frame_output.hpp"
#include "pliant/framework/frame.hpp"

namespace pliant::app {

/// The frames of a walker, kept until it can be written.
class KeptFrames {
 public:
  void add(const Frame& frame);
  /// Writes them to `output`, in their order, as frames of that walker.
  void write_to(FrameOutput& output, std::int64_t walker) const;

 private:
  struct Kept {
    Frame frame;  ///< without its spans
    std::vector<Vec3> positions;
    std::vector<std::uint8_t> limits_off;
  };
  std::vector<Kept> frames_;
};

/// Writes walkers in the order of their numbers, so that the same run gives the same file with any
/// number of threads. Calls must not overlap.
class WalkerSequence {
 public:
  WalkerSequence(FrameOutput output, std::int64_t first)
      : output_(std::move(output)), next_(first) {}

  /// Notes that the walker has ended. Throws as recorders do.
  void end(std::int64_t walker, KeptFrames frames);
  void close() { output_.close(); }

 private:
  FrameOutput output_;
  std::int64_t next_;  ///< the next walker to be written
  std::map<std::int64_t, KeptFrames> waiting_;
};

}  // namespace pliant::app
