// SPDX-License-Identifier: MIT
// A sample that commits its frames while it goes, and goes on behind the last of them.
#pragma once

#include <cstdint>
#include <span>

#include "commands/committed_walker.hpp"
#include "options/sample_settings.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/jobs/commit_log.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/sample/sample.hpp"

namespace pliant::app {

/// Observes frames twice: for the output, and for the log.
class CommittedSample {
 public:
  /// `parameters` are those of the output's header. Throws as CommitLog.
  CommittedSample(const SampleSettings& settings, const SampleTask& task,
                  std::span<const NamedParameter> parameters);

  /// Shows `observer` the committed frames, and makes the others. The summary is of these alone.
  SampleSummary run(const SampleObserver& observer);
  /// Once the output is whole: what was committed goes.
  void end();

 private:
  void commit();
  bool see(const Frame& frame, const SampleObserver& observer);
  SampleSummary make(std::int64_t first, const SampleObserver& observer);

  const SampleTask& task_;
  CommitLog log_;
  CommitClock clock_;
  KeptFrames kept_;          ///< since the last commit
  std::size_t frames_ = 0;   ///< committed
  std::int64_t next_frame_;  ///< behind the last frame seen
};

}  // namespace pliant::app
