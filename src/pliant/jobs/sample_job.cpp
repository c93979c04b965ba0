// SPDX-License-Identifier: MIT
#include "pliant/jobs/sample_job.hpp"

#include <algorithm>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/jobs/asked_amplitude.hpp"
#include "pliant/jobs/files/committed_walker.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/jobs/files/molecule_header.hpp"
#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/model/prepare/largest_molecule.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/molecule/selection.hpp"

namespace pliant {
namespace {

/// A sample has no walkers.
constexpr std::int64_t only_walker = 0;

/// Keeps frames in a log of commits, from which a sample that was killed goes on.
class CommittedSample {
 public:
  CommittedSample(const SampleTask& task, const OutputOptions& output,
                  std::span<const NamedParameter> parameters)
      : task_(task),
        log_(path_of(output.commits), key_of_run(task.framework(), task.start(), parameters),
             output.record.log),
        clock_(output.commit_seconds),
        next_frame_(task.options().first_frame) {}

  /// Shows `observer` the committed frames, and makes the others. The summary is of these alone.
  SampleSummary run(const SampleObserver& observer, const std::function<bool()>& should_stop) {
    if (const auto found = log_.committed(only_walker)) {
      frames_ = found->frames;
      next_frame_ = found->state.step + 1;
      log_.replay(only_walker, observer);
    }
    SampleSummary summary;
    if (should_stop && should_stop()) {
      summary.stopped_by_caller = true;
    } else if (next_frame_ < task_.options().first_frame + task_.options().frames) {
      summary = make(next_frame_, observer, should_stop);
    }
    if (summary.stopped_by_caller) commit();
    return summary;
  }

  /// Once the output is complete: what was committed goes.
  void end() { log_.remove(); }

 private:
  SampleSummary make(std::int64_t first, const SampleObserver& observer,
                     const std::function<bool()>& should_stop) {
    SampleOptions options = task_.options();
    options.frames -= first - options.first_frame;
    options.first_frame = first;
    options.should_stop = should_stop;
    return sample(task_.framework(), task_.start(), task_.nodes(), options,
                  [&](const Frame& frame) { return see(frame, observer); });
  }

  bool see(const Frame& frame, const SampleObserver& observer) {
    kept_.add(frame);
    next_frame_ = frame.step + 1;
    if (clock_.is_due()) commit();
    return observer(frame);
  }

  void commit() {
    if (kept_.size() == 0) return;
    State state;
    state.step = next_frame_ - 1;
    // A log counts the frames of all commits.
    log_.commit(only_walker, kept_, 0, state, false, frames_);
    frames_ += kept_.size();
    kept_ = {};
    clock_.restart();
  }

  const SampleTask& task_;
  CommitLog log_;
  CommitClock clock_;
  KeptFrames kept_;          ///< since the last commit
  std::size_t frames_ = 0;   ///< committed
  std::int64_t next_frame_;  ///< behind the last frame seen
};

/// The files that are read; "" for none.
std::vector<std::string> inputs_of(const Job& job) {
  std::vector<std::string> all = inputs_of(job.molecule);
  const std::string& amplitude = job.sample.amplitude_from;
  if (!parse_real(amplitude) && amplitude != "bfactors") all.push_back(amplitude);
  return all;
}

/// "54 hydrogen bonds, 4 salt bridges".
std::string counted_kinds(const std::vector<MolecularContact>& contacts) {
  std::string text;
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    const auto count = std::ranges::count(contacts, row.kind, &MolecularContact::kind);
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " ";
    text += count == 1 ? row.singular : row.plural;
  }
  return text;
}

AmplitudeChoice amplitude_of(const Job& job, const Structure& structure, const Log& log) {
  const std::string& text = job.sample.amplitude_from;
  if (!text.empty()) return asked_amplitude(text, structure, log);
  return {usual_amplitude, number_text(usual_amplitude), "the default; see --amplitude for others"};
}

SdfMolecule sdf_molecule(const Structure& structure) {
  return {structure.title, structure.charges, structure.isotopes, structure.radicals};
}

void refuse_single_node(const SampleJob& job) {
  if (job.task().nodes().positions.size() < 2)
    throw InputError(at({job.model().structure.source},
                        "holds one residue or atom: an ensemble needs two that can move apart"));
}

std::string recorded_text(const H5mdCheckpoint& from, const std::string& path) {
  for (const auto& [name, value] : from.parameters)
    if (name == path && std::holds_alternative<std::string>(value))
      return std::get<std::string>(value);
  return {};
}

H5mdCheckpoint read_sample(const std::string& file, std::optional<std::int64_t> frames,
                           const Log& log) {
  if (!is_there(path_of(file))) throw FileError(not_there(file));
  H5mdCheckpoint from = read_checkpoint(path_of(file), frames, log);
  if (!from.is_sample())
    throw InputError(path_text(from.path) +
                     ": holds steps of a run: pliant run --continue and continue_run go on with "
                     "them");
  return from;
}

/// Throws OptionError if the file has more frames than there are to be.
void check_count(const H5mdCheckpoint& from, std::string_view dashes) {
  if (from.done > from.steps)
    throw OptionError(option_name("frames", dashes) + (dashes.empty() ? " = " : " ") +
                      std::to_string(from.steps) + ": " + path_text(from.path) + " has " +
                      std::to_string(from.done) +
                      " frames already; frames are counted from the start of the sample");
}

}  // namespace

void settle_amplitude(std::string& text) {
  const auto number = parse_real(text);
  if (number && !(*number > 0.0))
    throw OptionError("--amplitude: expected a number above 0, found " + pliant::quoted(text));
  if (number) text = number_text(*number);
}

void check_open(SampleOptions options) {
  if (options.sampler == automatic_sampler) options.sampler = SampleOptions{}.sampler;
  if (options.frames == open_frames) options.frames = SampleOptions{}.frames;
  check(options);
}

void settle_sample(Job& job) {
  OutputOptions& output = job.output;
  settle_amplitude(job.sample.amplitude_from);
  check_open(job.sample);
  name_outputs(output, job.molecule.input.file, true);
  refuse_same_files(inputs_of(job), {output.output});
  check_trajectory_name(output.output, true);
  settle(output);
  const std::string topology = output.topology == no_topology ? "" : output.topology;
  refuse_same_files(inputs_of(job), {output.output, topology});
  refuse_to_replace({output.output, topology}, output);
}

MolecularModel sampled_model(Job& job, const Structure& structure,
                             std::optional<std::vector<MolecularContact>> contacts,
                             std::string_view dashes, const Log& log) {
  refuse_drawing(structure);
  ModelAsked& asked = job.molecule.model;
  const ModelEntry& row = entry(kind_of_model(asked, structure));
  check(asked, &row, dashes);
  asked.model = row.name;
  ModelOptions options = model_options_of(asked, row.kind, log);
  options.contacts = std::move(contacts);
  if (usual_model(structure) != ModelKind::molecule) return build_model(structure, options);
  return build_model(largest_molecule(structure, log), options);
}

SampleJob::SampleJob(Job job, MolecularModel model, std::string_view dashes, const Log& log)
    : job_(std::move(job)),
      model_(std::make_unique<MolecularModel>(std::move(model))),
      amplitude_(amplitude_of(job_, model_->structure, log)),
      log_(log) {
  job_.sample.log = job_.output.record.log = log;
  SampleAsked asked{job_.sample, std::nullopt, dashes};
  if (!job_.sample.amplitude_from.empty()) asked.amplitude = amplitude_;
  task_ = std::make_unique<SampleTask>(subject_of(*model_), asked);
  job_.sample = task_->options();
  job_.sample.amplitude_from = amplitude_.source;
  OutputOptions& output = job_.output;
  if (output.topology.empty()) output.topology = no_topology;
  output.record.saved = select_joints(task_->framework(), output.save, option_name("save", dashes));
}

SampledSystem SampleJob::system() const {
  return {std::string(entry(model_->kind).name),
          task_->framework(),
          model_->positions,
          amplitude_,
          model_->contacts.size(),
          model_->notes,
          model_->missing,
          model_->left_out,
          model_->placed,
          counted_kinds(model_->contacts)};
}

void SampleJob::fit_topology(bool is_asked) {
  OutputOptions& output = job_.output;
  output.topology = fitting_topology(output.topology, is_asked, task_->framework(),
                                     model_->positions, output.record);
}

H5mdHeader SampleJob::header() const {
  H5mdHeader header = molecule_header(model_->structure);
  header.parameters = parameters_of(job_);
  header.parameters.insert(header.parameters.end(),
                           {{"sample/amplitude_reason", amplitude_.reason}, left_out_of(*model_)});
  header.inputs = sample_inputs(task_->start(), task_->nodes());
  return header;
}

SampleSummary SampleJob::record(const SampleObserver& observer,
                                const std::function<bool()>& should_stop) {
  const OutputOptions& output = job_.output;
  const H5mdHeader contents = header();
  std::optional<CommittedSample> committed;
  if (!output.commits.empty()) committed.emplace(*task_, output, contents.parameters);
  FrameOutput recorder(output.output, task_->framework(), contents, output.record,
                       sdf_molecule(model_->structure));
  write_topology(output.topology, task_->framework(), contents, model_->positions, output.record);
  const SampleObserver recorded = [&](const Frame& frame) {
    recorder.record(frame);
    return observer(frame);
  };
  SampleSummary summary =
      committed ? committed->run(recorded, should_stop) : task_->run(recorded, should_stop);
  recorder.close();
  if (committed && !summary.stopped_by_caller) committed->end();
  return summary;
}

SampleSummary SampleJob::run(const SampleObserver& observer,
                             const std::function<bool()>& should_stop) {
  if (job_.output.output.empty()) return task_->run(observer, should_stop);
  refuse_single_node(*this);
  return record(observer, should_stop);
}

ContinuedSample::ContinuedSample(Job job, std::optional<std::int64_t> frames,
                                 std::string_view dashes, const Log& log)
    : job_(std::move(job)), from_(read_sample(job_.go_on, frames, log)), log_(log) {
  check_count(from_, dashes);
  const std::int64_t threads = job_.sample.threads;
  job_.sample = sample_options_from(from_);
  job_.sample.threads = threads;
  check(job_.sample);
  job_.sample.log = job_.output.record.log = log;
  job_.molecule.input.file = recorded_text(from_, "input/file");
  job_.molecule.model.model = recorded_text(from_, "model/kind");
  job_.output.output = job_.go_on;
  job_.output.topology = no_topology;
}

SampledSystem ContinuedSample::system() const {
  SampledSystem system{job_.molecule.model.model,
                       from_.framework,
                       from_.inputs.start,
                       {job_.sample.amplitude, recorded_text(from_, "sample/amplitude_from"),
                        recorded_text(from_, "sample/amplitude_reason")},
                       LimitCounter(from_.framework.limits()).size()};
  if (std::string left_out = recorded_text(from_, "model/left_out"); !left_out.empty())
    system.left_out.push_back(std::move(left_out));
  return system;
}

SampleSummary ContinuedSample::run(const SampleObserver& observer,
                                   const std::function<bool()>& should_stop) {
  if (from_.done >= from_.steps) {
    log_.note(path_text(from_.path) + " has all of its " + std::to_string(from_.steps) +
              " frames; --frames N goes on up to N in all");
    return {};
  }
  SampleOptions options = job_.sample;
  options.should_stop = should_stop;
  return add_frames(from_, options, job_.output.record, observer);
}

}  // namespace pliant
