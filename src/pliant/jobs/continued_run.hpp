// SPDX-License-Identifier: MIT
// A run that goes on from its files, as if it had never stopped.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/jobs/run_watch.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/run/ensemble.hpp"

namespace pliant {

class ContinuedRun {
 public:
  /// `job.go_on` names the file, or what those of its numbered walkers are named after; of the
  /// options those of walkers and of the output are heeded. `steps`: how many there are to be in
  /// all; none: as many as were asked for. Throws FileError where no file is there, InputError for
  /// one that holds no run, OptionError if it has more steps than that.
  ContinuedRun(Job job, std::optional<std::int64_t> steps, std::string_view dashes, const Log& log);

  /// With the options of the file.
  const Job& job() const { return job_; }
  /// The file of the first walker that was begun.
  const H5mdCheckpoint& from() const { return from_; }

  /// Runs the steps that are missing; walkers that were never begun begin. The summaries count the
  /// frames that are added. Throws InputError for a file of another run, and as run_ensemble().
  std::vector<RunSummary> run(const RunWatch& watch);

 private:
  std::vector<Vec3> start() const;
  Watchers watchers_of(std::int64_t walker, const RunWatch& watch);
  void record(Watchers& watchers, std::int64_t walker, std::shared_ptr<H5mdRecorder> recorder,
              std::int64_t frames_before, const RunWatch& watch);
  std::shared_ptr<H5mdRecorder> begin(const std::string& file, std::int64_t walker) const;
  void check_same_run(const H5mdCheckpoint& other, std::int64_t walker) const;

  Job job_;
  std::optional<std::int64_t> steps_;
  Log log_;
  H5mdCheckpoint from_;
  std::mutex counting_;
  std::int64_t frames_shown_ = 0;           ///< under the mutex
  std::vector<std::int64_t> frames_added_;  ///< by walker
};

}  // namespace pliant
