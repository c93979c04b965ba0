// SPDX-License-Identifier: MIT
#include "commands/walker_sequence.hpp"

#include <utility>

namespace pliant::app {

void KeptFrames::add(const Frame& frame) {
  Kept kept{frame,
            {frame.positions.begin(), frame.positions.end()},
            {frame.limits_off.begin(), frame.limits_off.end()}};
  kept.frame.previous = {};  // no run goes on from here
  frames_.push_back(std::move(kept));
}

void KeptFrames::write_to(FrameOutput& output, std::int64_t walker) const {
  for (const Kept& kept : frames_) {
    Frame frame = kept.frame;
    frame.positions = kept.positions;
    frame.limits_off = kept.limits_off;
    frame.walker = walker;
    output.record(frame);
  }
}

void WalkerSequence::end(std::int64_t walker, KeptFrames frames) {
  waiting_.emplace(walker, std::move(frames));
  while (!waiting_.empty() && waiting_.begin()->first == next_) {
    waiting_.begin()->second.write_to(output_, next_++);
    waiting_.erase(waiting_.begin());
  }
}

}  // namespace pliant::app
