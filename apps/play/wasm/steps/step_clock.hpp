// SPDX-License-Identifier: MIT
// The clock by which a page ends a step that will not arrive. Such a step is taken back as if it
// had not been asked for, so that no result depends on the time.
#pragma once

#include <chrono>
#include <cstdint>

namespace pliant::play {

class StepClock {
 public:
  /// 0: a step may take as long as it does.
  double milliseconds = 0.0;

  void begin() {
    start_ = Clock::now();
    asked_ = 0;
    runs_ = true;
  }
  void end() { runs_ = false; }
  /// Asked after each sweep. A busy machine is no reason to end what a few more sweeps may end.
  bool is_over() {
    if (!runs_ || milliseconds <= 0.0 || ++asked_ < fewest_sweeps) return false;
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count() > milliseconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::int64_t fewest_sweeps = 20;

  Clock::time_point start_;
  std::int64_t asked_ = 0;
  bool runs_ = false;  ///< only in a step of a person
};

}  // namespace pliant::play
