// SPDX-License-Identifier: MIT
#include "pliant/jobs/run_outputs.hpp"

#include <filesystem>
#include <utility>

#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/files/committed_walker.hpp"
#include "pliant/jobs/files/force_recorder.hpp"
#include "pliant/jobs/files/molecule_header.hpp"

namespace pliant {
namespace {

/// Records the pushes of a walker, or nothing.
std::optional<ForceRecorder> force_recorder(const RunToRecord& run, std::int64_t walker) {
  const Job& job = run.job;
  const std::string& name = job.walkers.record_forces;
  if (name.empty()) return {};
  // Such a run may go on for days.
  const bool is_counted = job.is_live && replayed_steps(job.run) == 0;
  ForceHeader header = force_header_of(job.molecule, run.subject);
  return std::optional<ForceRecorder>(std::in_place, path_of(of_walker(job.walkers, name, walker)),
                                      job.output.record.overwrite, run.subject.framework,
                                      force_file_of(job.run, std::move(header), is_counted),
                                      is_counted ? std::optional(longest_live_step) : std::nullopt);
}

/// One topology serves all walkers.
void write_topology(const RunToRecord& run) {
  const RunSubject& subject = run.subject;
  if (run.job.output.topology == no_topology) return;
  write_topology(run.job.output.topology, subject.framework, molecule_header(*subject.structure),
                 subject.start, run.job.output.record);
}

}  // namespace

std::string of_walker(const WalkersAsked& asked, const std::string& name, std::int64_t walker) {
  if (!asked.are_several()) return name;
  const std::filesystem::path path = path_of(name);
  const std::string numbered =
      path_text(path.stem()) + "-" + std::to_string(walker) + path_text(path.extension());
  return path_text(path.parent_path() / path_of(numbered));
}

std::string output_of(const Job& job, std::int64_t walker) {
  if (job.walkers.one_file) return job.output.output;
  return of_walker(job.walkers, job.output.output, walker);
}

EnsembleOptions ensemble_of(const Job& job, const RunWatch& watch) {
  const auto first = static_cast<std::uint64_t>(job.walkers.first);
  EnsembleOptions options{job.run,
                          {first, first + static_cast<std::uint64_t>(job.walkers.walkers)},
                          static_cast<int>(job.walkers.threads)};
  options.run.resolve.should_stop = watch.should_stop;
  return options;
}

/// The files of one walker.
struct RunOutputs::Walker {
  RunOutputs& outputs;
  std::int64_t number;
  std::optional<FrameOutput> trajectory;  ///< none where there is one for all, or none at all
  KeptFrames kept = {};
  std::optional<CommittedWalker> committed = {};
  std::optional<ForceRecorder> forces;
  std::int64_t last_step = 0;

  Walker(RunOutputs& all, std::int64_t walker)
      : outputs(all), number(walker), forces(force_recorder(all.run_, walker)) {
    const Job& job = all.run_.job;
    if (!all.one_file_ && !job.output.output.empty()) trajectory.emplace(all.trajectory_of(walker));
    if (all.commits_)
      committed.emplace(*all.commits_, walker, job.output.commit_seconds, job.run, kept);
  }

  bool keeps_forces() const {
    return !outputs.run_.keeps_forces_if_pulled || outputs.watch_.was_pulled();
  }

  bool record(const Frame& frame) {
    if (trajectory) trajectory->record(frame);
    if (outputs.one_file_) kept.add(frame);
    outputs.add_steps(frame.step - last_step);
    last_step = frame.step;
    return outputs.watch_.stops();
  }

  /// Goes on from the last commit, if there is one, and commits from then on.
  void watch_commits(Watchers& watchers, const std::shared_ptr<Walker>& self) {
    if (!committed) return;
    watchers.reached = committed->reached();
    if (watchers.reached) {
      last_step = watchers.reached->state.step;
      outputs.add_steps(last_step);
    }
    watchers.onlooker = {[self](std::int64_t step) { return self->committed->wants(step); },
                         [self](const Frame& frame) { self->committed->look(frame); }};
  }

  /// One file for all holds complete walkers only.
  void close(const RunSummary& summary, const State& state) {
    if (outputs.watch_.on_end) outputs.watch_.on_end(number, state);
    if (committed) committed->end(state, !summary.stopped_by_caller);
    if (trajectory) {
      trajectory->end_run(state);
      trajectory->close();
    }
    if (outputs.one_file_ && !summary.stopped_by_caller)
      outputs.one_file_->end(number, std::move(kept));
    if (forces && keeps_forces()) forces->publish();
  }
};

RunOutputs::RunOutputs(RunToRecord run, const RunWatch& watch, Log log)
    : run_(std::move(run)), watch_(watch), log_(std::move(log)) {
  const Job& job = run_.job;
  if (!job.output.commits.empty()) {
    const auto key =
        key_of_run(run_.subject.framework, run_.subject.start, run_.header_of(0).parameters);
    commits_ = std::make_unique<CommitLog>(path_of(job.output.commits), key, log_);
  }
  if (job.walkers.one_file)
    one_file_ =
        std::make_unique<OneFileOutput>(trajectory_of(job.walkers.first), job.walkers.first);
}

FrameOutput RunOutputs::trajectory_of(std::int64_t walker) const {
  return {output_of(run_.job, walker), run_.subject.framework, run_.header_of(walker),
          run_.job.output.record};
}

void RunOutputs::add_steps(std::int64_t steps) {
  if (!watch_.on_steps) return;
  const std::lock_guard hold(counting_);
  watch_.on_steps(steps_done_ += steps);
}

Watchers RunOutputs::watchers_of(std::int64_t walker) {
  const auto files = std::make_shared<Walker>(*this, walker);
  const bool is_first = walker == run_.job.walkers.first;
  if (is_first) write_topology(run_);
  Watchers watchers;
  watchers.observers = {[files](const Frame& frame) { return files->record(frame); }};
  if (watch_.observers_of)
    for (Observer& other : watch_.observers_of(walker))
      watchers.observers.push_back(std::move(other));
  if (files->forces) watchers.on_push = [files](const Push& push) { files->forces->record(push); };
  watchers.on_end = [files](const RunSummary& summary, const State& state) {
    files->close(summary, state);
  };
  if (is_first) watchers.log = log_;
  watchers.hands = watch_.hands;
  watchers.onlooker = watch_.onlooker;
  files->watch_commits(watchers, files);
  return watchers;
}

void RunOutputs::close(bool is_stopped) {
  if (one_file_) one_file_->close();
  if (commits_ && !is_stopped) commits_->remove();
}

}  // namespace pliant
