// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/one_file_output.hpp"

#include <utility>

namespace pliant {

void OneFileOutput::write(const KeptFrames& frames) {
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Frame frame = frames[k];
    frame.walker = next_;
    output_.record(frame);
  }
}

void OneFileOutput::end(std::int64_t walker, KeptFrames frames) {
  waiting_.emplace(walker, std::move(frames));
  while (!waiting_.empty() && waiting_.begin()->first == next_) {
    write(waiting_.begin()->second);
    ++next_;
    waiting_.erase(waiting_.begin());
  }
}

}  // namespace pliant
