// SPDX-License-Identifier: MIT
// Commits what walkers have reached while they go, and has them go on from there.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "pliant/jobs/files/commit_log.hpp"
#include "pliant/run/ensemble.hpp"

namespace pliant {

/// Tells when the next commit is due.
class CommitClock {
 public:
  explicit CommitClock(double seconds) : seconds_(seconds) {}
  bool is_due() const {
    return std::chrono::duration<double>(Clock::now() - last_).count() >= seconds_;
  }
  void restart() { last_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_;
  Clock::time_point last_ = Clock::now();
};

/// Commits one walker. Its frames are kept by the caller.
class CommittedWalker {
 public:
  CommittedWalker(CommitLog& log, std::int64_t walker, double seconds, const RunOptions& run,
                  KeptFrames& kept)
      : log_(log), walker_(walker), clock_(seconds), run_(run), kept_(kept) {}

  /// Where the walker goes on, if it was begun before; its frames are then among the kept ones.
  std::optional<WalkerReached> reached();
  /// Whether a commit is due after this step. What look() saw before is committed now: by then the
  /// frame of that step, if it is shown, is among the kept ones.
  bool wants(std::int64_t step);
  void look(const Frame& frame);
  void end(const State& state, bool is_done);

 private:
  void commit(const State& state, bool is_done);
  bool is_shown_early(const State& state) const;

  CommitLog& log_;
  std::int64_t walker_;
  CommitClock clock_;
  const RunOptions& run_;
  KeptFrames& kept_;
  std::size_t committed_ = 0;  ///< frames
  std::optional<State> seen_;
  bool was_done_ = false;
};

}  // namespace pliant
