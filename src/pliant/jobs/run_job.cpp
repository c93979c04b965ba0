// SPDX-License-Identifier: MIT
#include "pliant/jobs/run_job.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/base/version.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/jobs/files/molecule_header.hpp"
#include "pliant/jobs/files/run_checkpoint.hpp"
#include "pliant/jobs/replayed_forces.hpp"
#include "pliant/jobs/run_outputs.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

void check_guide(const Job& job) {
  if (job.guide.empty()) {
    if (job.was_given("amplitude")) throw OptionError("--amplitude: goes with --rock");
    return;
  }
  for (const char* name : {"perturb", "forces", "record_forces"})
    if (job.was_given(name))
      throw OptionError(option_name(name) +
                        ": goes with neither --rock, --pull nor --pair-distance");
  if (job.walkers.are_several())
    throw OptionError(
        "--walkers: all would go the same way with --rock, --pull or "
        "--pair-distance");
}

void check_one_file(Job& job) {
  if (!job.walkers.are_several())
    throw OptionError("one_file: is for several walkers: give walkers or shard");
  if (!job.go_on.empty())
    throw OptionError("one_file: such a file does not go on: commits keep what is done");
  job.output.record.flush_seconds = std::numeric_limits<double>::infinity();
}

/// The files that are read; "" for none.
std::vector<std::string> inputs_of(const Job& job) {
  std::vector<std::string> inputs = inputs_of(job.molecule);
  inputs.insert(inputs.end(), {job.walkers.forces, job.walkers.ordering});
  return inputs;
}

}  // namespace

void settle_walkers(Job& job) {
  check_guide(job);
  if (job.was_given("shard") && job.was_given("walkers"))
    throw OptionError("shard: is given in place of walkers, not together with them");
  number_walkers(job.walkers);
  if (job.is_live && job.walkers.are_several())
    throw OptionError("--imd: follows one walker, not several");
  if (job.walkers.one_file) check_one_file(job);
  if (!job.walkers.one_file && !job.output.commits.empty())
    throw OptionError("commits: goes with one_file; other trajectories have --continue");
  if (job.walkers.threads == 0) job.walkers.threads = all_processors();
}

RunJob::RunJob(Job job, std::string_view dashes) : job_(std::move(job)), dashes_(dashes) {
  settle();
  check_outputs();
  take_force_header(job_, replayed_);
  check_outputs();  // of inputs that the header names, too
}

/// What a client does is kept, so that the run can be repeated; where a force file can hold it.
void RunJob::settle() {
  if (!job_.output.output.empty()) pliant::settle(job_.output, dashes_);
  std::string& forces = job_.walkers.record_forces;
  const bool can_be_kept =
      job_.guide.empty() && (job_.run.perturb == "force" || !job_.walkers.forces.empty());
  if (!job_.is_live || !forces.empty() || !can_be_kept) return;
  forces = path_text(path_of(job_.output.output).replace_extension(".forces"));
  keeps_forces_if_pulled_ = true;
}

void RunJob::check_outputs() const {
  refuse_same_files(inputs_of(job_), {job_.output.output});
  check_trajectory_name(job_.output.output, false);
  refuse_same_files(inputs_of(job_), outputs());
}

std::vector<std::string> RunJob::outputs() const {
  std::vector<std::string> names;
  if (job_.output.topology != no_topology) names.push_back(job_.output.topology);
  const std::int64_t first = job_.walkers.first;
  for (std::int64_t walker = first; walker < first + job_.walkers.walkers; ++walker) {
    const std::string& forces = job_.walkers.record_forces;
    if (!job_.output.output.empty() && (!job_.walkers.one_file || walker == first))
      names.push_back(output_of(job_, walker));
    if (!forces.empty()) names.push_back(of_walker(job_.walkers, forces, walker));
  }
  return names;
}

void RunJob::take(const RunSubject& subject, const Log& log,
                  std::vector<NamedParameter> parameters) {
  subject_.emplace(subject);
  parameters_ = std::move(parameters);
  log_ = log;
  job_.molecule.model.model = subject.model;
  check_force_header(job_, replayed_, subject, log);
  complete();
  OutputOptions& output = job_.output;
  output.record.log = log;
  output.record.saved = select_joints(subject.framework, output.save, option_name("save", dashes_));
  refuse_to_replace(outputs(), output, dashes_);
  warn_if_doubtful(job_.run.technique, subject.framework, log);
}

void RunJob::fit_topology(bool is_asked) {
  OutputOptions& output = job_.output;
  output.topology = fitting_topology(output.topology, is_asked, subject_->framework,
                                     subject_->start, output.record);
}

void RunJob::check_record_forces() const {
  if (job_.walkers.record_forces.empty() || replayed_steps(job_.run) > 0 ||
      !replayed_.events.empty())
    return;
  const std::string option = option_name("record_forces", dashes_);
  if (!pushers_of(job_.run.guide).empty())
    throw OptionError(option + ": a guide pushes by no force: give no guide");
  if (job_.run.perturb != "force")
    throw OptionError(option + ": a force file holds one force on one joint a step, which " +
                      job_.run.perturb + " is not; use " +
                      (dashes_.empty() ? "perturb=\"force\"" : "--perturb force"));
}

/// The ordering of a file is the technique `input` with another input.
void RunJob::take_ordering() {
  if (job_.walkers.ordering.empty()) return;
  Technique& technique = job_.run.technique;
  if (!job_.was_given("technique")) technique.name = "input";
  if (technique.name != "input")
    throw OptionError("--ordering: goes with --technique input or none, not with " +
                      technique.name);
  technique.ordering = std::make_shared<Ordering>(
      read_ordering_file(path_of(job_.walkers.ordering), subject_->framework));
}

void RunJob::complete() {
  if (!job_.guide.empty())
    job_.run.guide = guide_from(job_.guide, *subject_->structure, subject_->framework);
  if (!job_.walkers.forces.empty()) take_forces(job_, replayed_, *subject_);
  check_record_forces();
  take_ordering();
  const bool is_left_to_auto = !job_.was_given("technique") && job_.walkers.ordering.empty() &&
                               job_.run.technique.name == "auto";
  if (is_left_to_auto && job_.was_given("weighting")) job_.run.technique.name = "bfs_cycle";
}

H5mdHeader RunJob::header(std::int64_t walker) const {
  H5mdHeader header;
  if (subject_->structure != nullptr) header = molecule_header(*subject_->structure);
  header.creator_version = std::string(version());
  header.parameters = parameters_of(job_, replayed_, *subject_, walker);
  header.parameters.insert(header.parameters.end(), parameters_.begin(), parameters_.end());
  header.several_walkers = job_.walkers.one_file;
  if (job_.walkers.one_file) return header;  // a run of several goes on from no one file
  header.inputs = run_inputs(job_.run);
  if (job_.walkers.are_several())
    header.inputs->start.assign(subject_->start.begin(), subject_->start.end());
  return header;
}

RunToRecord RunJob::recorded() const {
  return {job_, *subject_, [this](std::int64_t walker) { return header(walker); },
          keeps_forces_if_pulled_};
}

std::vector<RunSummary> RunJob::run(const State& start, const RunWatch& watch) {
  if (!replayed_.events.empty()) {
    State moved = start;
    return {run_alone(moved, watch)};
  }
  RunOutputs outputs(recorded(), watch, log_);
  std::vector<RunSummary> summaries = run_ensemble(
      subject_->framework, start, ensemble_of(job_, watch),
      [&](std::uint64_t walker) { return outputs.watchers_of(static_cast<std::int64_t>(walker)); });
  outputs.close(watch.stops());
  return summaries;
}

RunSummary RunJob::run_alone(State& state, const RunWatch& watch) {
  RunOutputs outputs(recorded(), watch, log_);
  const Watchers watchers = outputs.watchers_of(job_.walkers.first);
  RunSummary summary;
  if (!replayed_.events.empty()) {
    const ReplayOptions options{job_.walkers.forces, job_.run.every, watch.should_stop, log_};
    summary =
        replay_events(subject_->framework, state, replayed_.events, options, watchers.observers);
  } else {
    RunOptions options = ensemble_of(job_, watch).run;
    options.resolve.walker = static_cast<std::uint64_t>(job_.walkers.first);
    options.on_push = watchers.on_push;
    options.hands = watchers.hands;
    options.onlooker = watchers.onlooker;
    options.log = log_;
    summary = pliant::run(subject_->framework, state, options, watchers.observers);
  }
  watchers.on_end(summary, state);
  return summary;
}

std::vector<NamedParameter> parameters_of(const Job& job, const ReplayedForces& replayed,
                                          const RunSubject& subject, std::int64_t walker) {
  Job of_walker = job;
  of_walker.run.resolve.walker = static_cast<std::uint64_t>(walker);
  of_walker.molecule.bars.bars = bars_of(job.molecule);
  std::vector<NamedParameter> values = parameters_of(of_walker);
  for (NamedParameter& one : parameters_of(of_walker.run, subject.framework)) {
    const auto there = std::ranges::find(values, one.first, &NamedParameter::first);
    there == values.end() ? values.push_back(std::move(one)) : void(*there = std::move(one));
  }
  if (!replayed.events.empty())
    for (auto& [path, value] : values)
      if (path == "run/perturb") value = std::string(events_perturbation);
  if (const std::string edits = edits_text(replayed.events, subject.framework); !edits.empty())
    values.emplace_back("run/edits", edits);
  if (job.walkers.one_file) values.emplace_back("run/walkers", job.walkers.walkers);
  if (subject.is_given)
    std::erase_if(values, [](const auto& one) {
      return one.first.starts_with("input/") && one.first != "input/file";
    });
  return values;
}

}  // namespace pliant
