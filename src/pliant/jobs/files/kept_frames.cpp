// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/kept_frames.hpp"

#include <utility>

namespace pliant {

void KeptFrames::add(const Frame& frame) {
  Kept kept{frame,
            {frame.positions.begin(), frame.positions.end()},
            {frame.limits_off.begin(), frame.limits_off.end()}};
  kept.frame.previous = {};
  frames_.push_back(std::move(kept));
}

Frame KeptFrames::operator[](std::size_t k) const {
  Frame frame = frames_[k].frame;
  frame.positions = frames_[k].positions;
  frame.limits_off = frames_[k].limits_off;
  return frame;
}

}  // namespace pliant
