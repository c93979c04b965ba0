// SPDX-License-Identifier: MIT
// The job `run`: from what is asked for to frames, in memory or in files. The command and Python
// use it; continued_run.hpp goes on with its files.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/jobs/replayed_header.hpp"
#include "pliant/jobs/run_outputs.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Sets the numbers of the walkers, and one thread for each core where nothing else is asked for.
/// Throws OptionError for options that exclude each other.
void settle_walkers(Job& job);

class RunJob {
 public:
  /// Reads the force file, which may say how a molecule is read. The walkers have their numbers.
  /// `dashes`: prefix of an option's name in messages. Throws OptionError for options that exclude
  /// each other and for outputs that are inputs, and as take_force_header() does.
  RunJob(Job job, std::string_view dashes);

  const Job& job() const { return job_; }
  const ReplayedForces& replayed() const { return replayed_; }

  /// Makes all choices that are left open, now that it is known what is run, which must outlive
  /// this. `parameters` are further ones of its files. Throws OptionError, InputError as the
  /// readers of a force file and of an ordering do, FileError for outputs that are there.
  void take(const RunSubject& subject, const Log& log, std::vector<NamedParameter> parameters = {});

  /// Called before anything is made: see fitting_topology().
  void fit_topology(bool is_asked);

  /// Runs all walkers on the threads of the job. The result of a walker depends on the seed and its
  /// number alone. One that cannot be recorded stops, and the others go on. Throws the exception of
  /// the first walker that failed, once all have ended.
  std::vector<RunSummary> run(const State& start, const RunWatch& watch);

  /// Runs a single walker, which moves `state`. Throws as run().
  RunSummary run_alone(State& state, const RunWatch& watch);

  /// Contents of the file of a walker, or of the file of all.
  H5mdHeader header(std::int64_t walker) const;

  /// The files of these walkers.
  std::vector<std::string> outputs() const;

 private:
  void settle();
  RunToRecord recorded() const;
  void check_outputs() const;
  void check_record_forces() const;
  void complete();
  void take_ordering();

  Job job_;
  std::string dashes_;
  Log log_;
  ReplayedForces replayed_;
  std::optional<RunSubject> subject_;
  std::vector<NamedParameter> parameters_;
  bool keeps_forces_if_pulled_ = false;
};

/// Every option of a walker's run as its file keeps it, below /parameters.
std::vector<NamedParameter> parameters_of(const Job& job, const ReplayedForces& replayed,
                                          const RunSubject& subject, std::int64_t walker);

}  // namespace pliant
