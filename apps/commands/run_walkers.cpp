// SPDX-License-Identifier: MIT
#include "commands/run_walkers.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

#include "interrupt.hpp"
#include "messages.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/files/committed_walker.hpp"
#include "pliant/jobs/files/force_recorder.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/jobs/files/molecule_header.hpp"
#include "pliant/jobs/files/recorded_run.hpp"
#include "pliant/jobs/files/walker_sequence.hpp"
#include "pliant/run/ensemble.hpp"
#include "pliant/run/replay_events.hpp"

namespace pliant::app {
namespace {

H5mdHeader header_of(const RunSettings& settings, const Molecule& molecule, std::int64_t walker) {
  H5mdHeader header = molecule_header(molecule.structure);
  header.parameters = parameters_of(settings, molecule.framework, walker);
  header.several_walkers = settings.job.walkers.one_file;
  if (settings.job.walkers.one_file) return header;  // a run of several goes on from no one file
  header.inputs = run_inputs(settings.job.run);
  if (settings.job.walkers.are_several()) header.inputs->start = molecule.structure.positions;
  return header;
}

/// What the walkers share.
struct Shared {
  const RunSettings& settings;
  const Molecule& molecule;
  const Log& log;
  ProgressBar& progress;
  std::vector<Vec3>& last;
  LiveRun* live;                                  ///< null: nobody looks
  std::unique_ptr<WalkerSequence> sequence = {};  ///< of --one-file; else null
  std::unique_ptr<CommitLog> commits = {};        ///< null: none are kept
  std::mutex showing = {};
  std::int64_t steps_done = 0;  ///< under the mutex

  void add_steps(std::int64_t steps) {
    const std::lock_guard hold(showing);
    progress.show(steps_done += steps);
  }
};

FrameOutput output_for(const Shared& shared, std::int64_t walker) {
  const RunSettings& settings = shared.settings;
  return {output_of(settings, walker), shared.molecule.framework,
          header_of(settings, shared.molecule, walker), settings.job.output.record};
}

/// One sidecar serves all walkers.
void write_sidecar(const Shared& shared) {
  const Structure& structure = shared.molecule.structure;
  write_topology(shared.settings.job.output.topology, shared.molecule.framework,
                 molecule_header(structure), structure.positions,
                 shared.settings.job.output.record);
}

/// Records a walker's pushes, or nothing.
std::optional<ForceRecorder> force_recorder(const Shared& shared, std::int64_t walker) {
  const RunSettings& settings = shared.settings;
  if (settings.job.walkers.record_forces.empty()) return {};
  // Such a run may go on for days.
  const bool is_counted = shared.live != nullptr && replayed_steps(settings.job.run) == 0;
  return std::optional<ForceRecorder>(
      std::in_place, path_of(of_walker(settings, settings.job.walkers.record_forces, walker)),
      settings.job.output.record.overwrite, shared.molecule.framework,
      force_file_of(settings.job.run, force_header_of(settings.job.molecule, shared.molecule),
                    is_counted),
      is_counted ? std::optional(LiveRun::longest_step) : std::nullopt);
}

/// The outputs of a walker.
struct RecordedWalker {
  Shared& shared;
  std::int64_t walker;
  std::optional<FrameOutput> recorder;  ///< none where there is one file for all
  KeptFrames kept = {};
  std::optional<CommittedWalker> committed = {};
  std::optional<ForceRecorder> forces;
  std::int64_t last_step = 0;

  RecordedWalker(Shared& shared_things, std::int64_t number)
      : shared(shared_things), walker(number), forces(force_recorder(shared, walker)) {
    if (!shared.sequence) recorder.emplace(output_for(shared, walker));
    if (shared.commits)
      committed.emplace(*shared.commits, walker, shared.settings.job.output.commit_seconds,
                        shared.settings.job.run, kept);
  }

  bool keeps_forces() const {
    return !shared.settings.imd.keeps_forces_if_pulled || shared.live->was_pulled();
  }

  bool record(const Frame& frame) {
    recorder ? recorder->record(frame) : kept.add(frame);
    shared.add_steps(frame.step - last_step);
    last_step = frame.step;
    return interrupted() || (shared.live != nullptr && shared.live->was_killed());
  }

  /// Goes on from the last commit, if there is one, and commits from then on.
  void watch_commits(Watchers& watchers, const std::shared_ptr<RecordedWalker>& self) {
    if (!committed) return;
    watchers.reached = committed->reached();
    if (watchers.reached) {
      last_step = watchers.reached->state.step;
      shared.add_steps(last_step);
    }
    watchers.onlooker = {[self](std::int64_t step) { return self->committed->wants(step); },
                         [self](const Frame& frame) { self->committed->look(frame); }};
  }

  /// One file for all holds whole walkers only.
  void close(const RunSummary& summary, const State& state) {
    if (committed) committed->end(state, !summary.stopped_by_caller);
    if (recorder) {
      recorder->end_run(state);
      recorder->close();
    } else if (!summary.stopped_by_caller) {
      shared.sequence->end(walker, std::move(kept));
    }
    if (forces && keeps_forces()) forces->publish();
  }
};

Watchers recorded(Shared& shared, std::int64_t walker) {
  const auto outputs = std::make_shared<RecordedWalker>(shared, walker);
  if (walker == shared.settings.job.walkers.first) write_sidecar(shared);
  Watchers watchers;
  watchers.observers = {[outputs](const Frame& frame) { return outputs->record(frame); }};
  if (outputs->forces)
    watchers.on_push = [outputs](const Push& push) { outputs->forces->record(push); };
  watchers.on_end = [outputs, &shared](const RunSummary& summary, const State& state) {
    if (shared.live != nullptr) shared.live->finish();
    outputs->close(summary, state);
    if (!shared.settings.job.walkers.are_several()) shared.last = state.positions;
  };
  if (walker == shared.settings.job.walkers.first) watchers.log = shared.log;
  if (shared.live != nullptr) {
    // A port that nobody chose has to be said.
    if (!shared.settings.printing.quiet || shared.settings.imd.port == 0)
      shared.live->say_where(shared.settings.job.output.topology);
    watchers.hands = shared.live->hands();
    watchers.onlooker = shared.live->onlooker();
  }
  outputs->watch_commits(watchers, outputs);
  return watchers;
}

std::unique_ptr<CommitLog> commit_log(const Shared& shared) {
  const H5mdHeader header = header_of(shared.settings, shared.molecule, 0);
  const auto key =
      key_of_run(shared.molecule.framework, shared.molecule.structure.positions, header.parameters);
  return std::make_unique<CommitLog>(path_of(shared.settings.job.output.commits), key, shared.log);
}

/// What a person did, once more.
RunSummary replay(Shared& shared) {
  const Watchers watchers = recorded(shared, 0);
  State state(shared.molecule.structure.positions);
  ReplayOptions options{shared.settings.job.walkers.forces, shared.settings.job.run.every,
                        interrupted, shared.log};
  const RunSummary summary = replay_events(shared.molecule.framework, state, shared.settings.events,
                                           options, watchers.observers);
  watchers.on_end(summary, state);
  return summary;
}

}  // namespace

std::vector<RunSummary> run_walkers(const RunSettings& settings, const Molecule& molecule,
                                    const Log& log, std::vector<Vec3>& last, LiveRun* live) {
  ProgressBar progress(settings.job.walkers.walkers * settings.job.run.steps, "steps",
                       settings.printing.quiet);
  Shared shared{settings, molecule, log, progress, last, live};
  if (!settings.events.empty()) return {replay(shared)};
  if (!settings.job.output.commits.empty()) shared.commits = commit_log(shared);
  if (settings.job.walkers.one_file)
    shared.sequence = std::make_unique<WalkerSequence>(
        output_for(shared, settings.job.walkers.first), settings.job.walkers.first);
  const auto first = static_cast<std::uint64_t>(settings.job.walkers.first);
  EnsembleOptions options{settings.job.run,
                          {first, first + static_cast<std::uint64_t>(settings.job.walkers.walkers)},
                          static_cast<int>(settings.job.walkers.threads)};
  options.run.resolve.should_stop = [live] {
    return interrupted() || (live != nullptr && live->was_killed());
  };
  std::vector<RunSummary> summaries = run_ensemble(
      molecule.framework, State(molecule.structure.positions), options,
      [&](std::uint64_t walker) { return recorded(shared, static_cast<std::int64_t>(walker)); });
  if (shared.sequence) shared.sequence->close();
  if (shared.commits && !interrupted()) shared.commits->remove();
  return summaries;
}

}  // namespace pliant::app
