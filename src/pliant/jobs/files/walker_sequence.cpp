// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/walker_sequence.hpp"

#include <utility>

namespace pliant {

void WalkerSequence::write(const KeptFrames& frames) {
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Frame frame = frames[k];
    frame.walker = next_;
    output_.record(frame);
  }
}

void WalkerSequence::end(std::int64_t walker, KeptFrames frames) {
  waiting_.emplace(walker, std::move(frames));
  while (!waiting_.empty() && waiting_.begin()->first == next_) {
    write(waiting_.begin()->second);
    ++next_;
    waiting_.erase(waiting_.begin());
  }
}

}  // namespace pliant
