// SPDX-License-Identifier: MIT
// Several walkers in one trajectory, one after another, though they run side by side.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "output/frame_output.hpp"
#include "pliant/framework/frame.hpp"

namespace pliant::app {

/// The frames of a walker, kept until its turn comes.
class KeptFrames {
 public:
  void add(const Frame& frame);
  /// Hands them to `output`, in their order, as frames of that walker.
  void write_to(FrameOutput& output, std::int64_t walker) const;

 private:
  struct Kept {
    Frame frame;  ///< its spans are not to be looked at
    std::vector<Vec3> positions;
    std::vector<std::uint8_t> limits_off;
  };
  std::vector<Kept> frames_;
};

/// Writes walkers in the order of their numbers, so that the same run gives the same file on any
/// number of threads. Calls must come one after another.
class WalkerSequence {
 public:
  WalkerSequence(FrameOutput output, std::int64_t first)
      : output_(std::move(output)), next_(first) {}

  /// The walker has come to its end. Throws as recorders do.
  void end(std::int64_t walker, KeptFrames frames);
  void close() { output_.close(); }

 private:
  FrameOutput output_;
  std::int64_t next_;  ///< the walker to be written next
  std::map<std::int64_t, KeptFrames> waiting_;
};

}  // namespace pliant::app
