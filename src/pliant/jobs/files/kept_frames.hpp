// SPDX-License-Identifier: MIT
// Frames that are kept in memory until they can be written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/framework/frame.hpp"

namespace pliant {

/// Frames of one walker, in their order, without the positions of a step before.
class KeptFrames {
 public:
  /// Copies what the frame's spans show.
  void add(const Frame& frame);
  void remove_last() { frames_.pop_back(); }
  std::size_t size() const { return frames_.size(); }
  /// The k-th frame. Its spans are valid until the next call of add().
  Frame operator[](std::size_t k) const;

 private:
  struct Kept {
    Frame frame;  ///< without its spans
    std::vector<Vec3> positions;
    std::vector<std::uint8_t> limits_off;
  };
  std::vector<Kept> frames_;
};

}  // namespace pliant
