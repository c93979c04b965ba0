// SPDX-License-Identifier: MIT
// The job `sample`: from what is asked for to frames, in memory or in a file. The command, Python,
// shards, studies and `--continue` all use it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant {

/// What is sampled, for people. The framework must outlive it.
struct SampledSystem {
  std::string kind;  ///< name of the model
  const Framework& framework;
  std::span<const Vec3> start;  ///< (N) Angstrom
  AmplitudeChoice amplitude = {};
  std::size_t contacts = 0;
  std::vector<std::string> notes = {}, missing = {}, left_out = {};  ///< from preparation
  std::size_t placed = 0;                                            ///< atoms placed by rule
  std::string kinds = {};  ///< of contacts: "54 hydrogen bonds, 4 salt bridges"
};

/// Writes a number in one way; throws OptionError for one that is not above 0.
void settle_amplitude(std::string& amplitude_from);

/// Throws as check() of options that the job has yet to complete: no file is read before.
void check_open(SampleOptions options);

/// Settles what is open before the molecule is known: names of outputs. Throws OptionError for
/// options out of range and outputs that are inputs, FileError for outputs that are there.
void settle_sample(Job& job);

/// The model that is sampled of a structure; its kind is put into the job. Of a small molecule with
/// others beside it the largest is taken. Throws as build_model().
/// `contacts`: those that replace the ones to be found, as ModelOptions::contacts.
MolecularModel sampled_model(Job& job, const Structure& structure,
                             std::optional<std::vector<MolecularContact>> contacts,
                             std::string_view dashes, const Log& log);

/// A sample that is ready to run.
class SampleJob {
 public:
  /// Makes all choices that are left open. `dashes`: prefix of an option's name in messages. Throws
  /// as SampleTask and asked_amplitude() do.
  SampleJob(Job job, MolecularModel model, std::string_view dashes, const Log& log);

  const Job& job() const { return job_; }
  const MolecularModel& model() const { return *model_; }
  const SampleTask& task() const { return *task_; }
  SampledSystem system() const;
  /// Called before anything is made: see fitting_topology().
  void fit_topology(bool is_asked);
  /// Contents of a file of its frames.
  H5mdHeader header() const;

  /// Makes the frames, records them where the job names an output, and shows them. With commits it
  /// goes on from there; the summary is of the frames made now. Throws as sample() and the
  /// recorders do.
  SampleSummary run(const SampleObserver& observer, const std::function<bool()>& should_stop = {});

 private:
  SampleSummary record(const SampleObserver& observer, const std::function<bool()>& should_stop);

  Job job_;
  std::unique_ptr<MolecularModel> model_;
  AmplitudeChoice amplitude_;
  std::unique_ptr<SampleTask> task_;
  Log log_;
};

/// A sample that goes on from its file.
class ContinuedSample {
 public:
  /// `job.go_on` names the file; of the options `threads` and those of the output are heeded.
  /// `frames`: how many there are to be in all; none: as many as were asked for. Throws InputError
  /// if the file holds no sample, OptionError if it has more frames than that.
  ContinuedSample(Job job, std::optional<std::int64_t> frames, std::string_view dashes,
                  const Log& log);

  /// With the options of the file.
  const Job& job() const { return job_; }
  const H5mdCheckpoint& from() const { return from_; }
  SampledSystem system() const;
  /// Adds the frames that are missing, and shows these.
  SampleSummary run(const SampleObserver& observer, const std::function<bool()>& should_stop = {});

 private:
  Job job_;
  H5mdCheckpoint from_;
  Log log_;
};

}  // namespace pliant
