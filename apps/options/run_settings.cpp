// SPDX-License-Identifier: MIT
#include "options/run_settings.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <thread>

#include "messages.hpp"
#include "options/force_file_input.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

/// The ordering of a file is the technique `input` with another input.
void take_ordering(const CommandLine& line, RunSettings& settings, const Framework& framework) {
  Technique& technique = settings.job.run.technique;
  if (!line.was_given("--technique")) technique.name = "input";
  if (technique.name != "input")
    throw OptionError("--ordering: goes with --technique input or none, not with " +
                      technique.name);
  technique.ordering = std::make_shared<Ordering>(
      read_ordering_file(path_of(settings.job.walkers.ordering), framework));
}

void check_guide(const CommandLine& line, const RunSettings& settings) {
  if (settings.job.guide.empty()) {
    for (const char* option : {"--rock-amplitude", "--period"})
      if (line.was_given(option)) throw OptionError(std::string(option) + ": goes with --rock");
    return;
  }
  for (const char* option : {"--perturb", "--forces", "--record-forces"})
    if (line.was_given(option))
      throw OptionError(std::string(option) +
                        ": goes with neither --rock, --pull nor --pair-distance");
  if (settings.job.walkers.are_several())
    throw OptionError(
        "--walkers: all would go the same way with --rock, --pull or "
        "--pair-distance");
}

void check_one_file(RunSettings& settings) {
  if (!settings.job.walkers.are_several())
    throw OptionError("--one-file: is for several walkers; give --walkers or --shard");
  if (!settings.job.go_on.empty())
    throw OptionError("--one-file: such a file does not go on; --commits keeps what is done");
  settings.job.output.record.flush_seconds = std::numeric_limits<double>::infinity();
}

void check_record_forces(const RunSettings& settings) {
  if (settings.job.walkers.record_forces.empty() || !settings.job.walkers.forces.empty()) return;
  if (settings.job.run.perturb != "force")
    throw OptionError("--record-forces: a force file holds one force on one joint a step, which " +
                      settings.job.run.perturb + " is not; use --perturb force");
}

/// What a client does is kept, so that the run can be repeated; where a force file can hold it.
void name_live_forces(RunSettings& settings) {
  const bool can_be_kept = settings.job.guide.empty() && (settings.job.run.perturb == "force" ||
                                                          !settings.job.walkers.forces.empty());
  if (!settings.imd.is_asked || !settings.job.walkers.record_forces.empty() || !can_be_kept) return;
  settings.job.walkers.record_forces =
      path_text(path_of(settings.job.output.output).replace_extension(".forces"));
  settings.imd.keeps_forces_if_pulled = true;
}

}  // namespace

void add_run_options(CommandLine& line, RunSettings& settings) {
  add_job_options(line, settings.job);
  add_printing_options(line, settings.printing);
  add_imd_options(line, settings.imd);
}

void number_walkers(const CommandLine& line, RunSettings& settings) {
  WalkersAsked& walkers = settings.job.walkers;
  check_guide(line, settings);
  if (line.was_given("--shard") && line.was_given("--walkers"))
    throw OptionError("--shard: is given in place of --walkers, not together with it");
  number_walkers(walkers);
  check_imd(line, settings.imd, walkers.are_several());
  if (walkers.one_file) check_one_file(settings);
  const std::string& commits = settings.job.output.commits;
  if (line.was_given("--commit-seconds") && commits.empty())
    throw OptionError("--commit-seconds: goes with --commits");
  if (!walkers.one_file && !commits.empty())
    throw OptionError("--commits: goes with --one-file; other trajectories have --continue");
}

void settle(const CommandLine& line, RunSettings& settings) {
  number_walkers(line, settings);
  name_outputs(settings.job.output, settings.job.molecule.input.file,
               settings.job.walkers.first == 0);
  settle(settings.job.output);
  name_live_forces(settings);
}

void complete(const CommandLine& line, RunSettings& settings, const Molecule& molecule) {
  const Framework& framework = molecule.framework;
  if (settings.job.walkers.threads == 0)
    settings.job.walkers.threads = std::thread::hardware_concurrency();
  check_record_forces(settings);
  settings.job.run.guide = guide_from(settings.job.guide, molecule.structure, framework);
  if (!settings.job.walkers.forces.empty()) take_forces(line, settings, molecule);
  if (!settings.job.walkers.ordering.empty()) take_ordering(line, settings, framework);
  const bool is_left_to_auto = !line.was_given("--technique") &&
                               settings.job.walkers.ordering.empty() &&
                               settings.job.run.technique.name == "auto";
  if (is_left_to_auto && line.was_given("--weighting"))
    settings.job.run.technique.name = "bfs_cycle";
}

std::string of_walker(const RunSettings& settings, const std::string& name, std::int64_t walker) {
  if (!settings.job.walkers.are_several()) return name;
  const fs::path path = path_of(name);
  const std::string numbered =
      path_text(path.stem()) + "-" + std::to_string(walker) + path_text(path.extension());
  return path_text(path.parent_path() / path_of(numbered));
}

std::string output_of(const RunSettings& settings, std::int64_t walker) {
  if (settings.job.walkers.one_file) return settings.job.output.output;
  return of_walker(settings, settings.job.output.output, walker);
}

std::vector<NamedParameter> parameters_of(const RunSettings& settings, const Framework& framework,
                                          std::int64_t walker) {
  RunOptions run = settings.job.run;
  run.resolve.walker = static_cast<std::uint64_t>(walker);
  Job job = settings.job;
  job.molecule.bars.bars = bars_of(job.molecule);
  std::vector<NamedParameter> values = parameters_of(job);
  for (NamedParameter& one : pliant::parameters_of(run, framework)) {
    const auto there = std::ranges::find(values, one.first, &NamedParameter::first);
    there == values.end() ? values.push_back(std::move(one)) : void(*there = std::move(one));
  }
  if (!settings.events.empty())
    for (auto& [path, value] : values)
      if (path == "run/perturb") value = std::string(events_perturbation);
  if (const std::string edits = edits_text(settings.events, framework); !edits.empty())
    values.emplace_back("run/edits", edits);
  if (settings.job.walkers.one_file)
    values.emplace_back("run/walkers", settings.job.walkers.walkers);
  return values;
}

}  // namespace pliant::app
