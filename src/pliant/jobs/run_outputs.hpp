// SPDX-License-Identifier: MIT
// The files of a run: a trajectory for each walker or one for all, names and bonds, forces,
// commits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "pliant/jobs/files/commit_log.hpp"
#include "pliant/jobs/files/one_file_output.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/jobs/run_watch.hpp"
#include "pliant/run/ensemble.hpp"

namespace pliant {

/// Name of a file of a walker: `name` itself if there is only one walker and no shard.
std::string of_walker(const WalkersAsked& asked, const std::string& name, std::int64_t walker);

/// Name of the trajectory of a walker, which all may share.
std::string output_of(const Job& job, std::int64_t walker);

/// Which walkers are run, how, and on how many threads.
EnsembleOptions ensemble_of(const Job& job, const RunWatch& watch);

/// What files and observers of a run need to know of it. All must outlive them.
struct RunToRecord {
  const Job& job;
  RunSubject subject;
  std::function<H5mdHeader(std::int64_t walker)> header_of;
  bool keeps_forces_if_pulled = false;
};

class RunOutputs {
 public:
  /// Opens what all walkers share. Throws as the recorders do.
  RunOutputs(RunToRecord run, const RunWatch& watch, Log log);

  /// Opens the files of a walker, which goes on from its last commit. Throws as the recorders do.
  Watchers watchers_of(std::int64_t walker);
  /// Closes what all walkers share. `is_stopped`: commits are kept, to go on from.
  void close(bool is_stopped);

 private:
  struct Walker;

  FrameOutput trajectory_of(std::int64_t walker) const;
  void add_steps(std::int64_t steps);

  RunToRecord run_;
  const RunWatch& watch_;
  Log log_;
  std::unique_ptr<OneFileOutput> one_file_;  ///< of one file for all; else null
  std::unique_ptr<CommitLog> commits_;       ///< null: none are kept
  std::mutex counting_;
  std::int64_t steps_done_ = 0;  ///< under the mutex
};

}  // namespace pliant
