// SPDX-License-Identifier: MIT
#include "options/run_settings.hpp"

#include <filesystem>
#include <limits>
#include <thread>

#include "messages.hpp"
#include "options/force_file_input.hpp"
#include "options/option_fields.hpp"
#include "output/frame_output.hpp"
#include "output/output_files.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;
constexpr std::int64_t most_walkers = 1'000'000;

void add_fields(CommandLine& line, RunOptions& run, std::string_view group) {
  for (const RunField& field : run_fields())
    if (field.group == group) add_option(line, field, field.place(run));
}

void add_technique_options(CommandLine& line, RunSettings& settings) {
  line.start_group("Technique");
  add_fields(line, settings.run, "Technique");
  line.add_text("--ordering", settings.ordering, "FILE",
                "visit the bars in the order listed in this file; replaces --technique");
}

void add_perturb_options(CommandLine& line, RunSettings& settings) {
  line.start_group("Perturbation");
  add_fields(line, settings.run, "Perturbation");
  line.add_text("--forces", settings.forces, "FILE",
                "replay a force file: one push per step, or what was done by hand;\n"
                "replaces --perturb. Options that the file holds need not be given");
  line.add_flag("--override-forces", settings.override_forces,
                "if options or the structure contradict --forces, the command line wins");
  line.add_text("--record-forces", settings.record_forces, "FILE",
                "write the push of each step to a force file, for --forces");
}

void add_output_options(CommandLine& line, RunSettings& settings) {
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FILE",
                "H5MD trajectory, or a PDB file with a model per frame (name ends in .pdb)\n"
                "(default: INPUT's name.h5md)");
  line.add_text("--topology", settings.topology, "FILE",
                "PDB file of names and bonds to write, or none (default: OUTPUT's name.pdb)");
  line.add_flag("--overwrite", settings.record.overwrite, "replace existing outputs");
  line.add_flag("--durable", settings.record.durable,
                "wait for the disk at each commit, so that frames survive a power cut");
  line.add_flag("--single", settings.record.single, "positions as 32-bit floats");
  line.add_flag("--compress", settings.record.compress, "shuffle and gzip positions");
  add_saving_options(line, settings.save, settings.record);
  line.add_flag("--dry-run", settings.dry_run,
                "read the input, check all options, and write nothing");
  line.add_flag("--json", settings.json, "print the summary as one JSON object");
  line.add_flag("--quiet", settings.quiet, "print nothing but errors");
  add_verbose(line, settings.verbose);
}

/// The ordering of a file is the technique `input` with another input.
void take_ordering(const CommandLine& line, RunSettings& settings, const Framework& framework) {
  Technique& technique = settings.run.technique;
  if (!line.was_given("--technique")) technique.name = "input";
  if (technique.name != "input")
    throw OptionError("--ordering: goes with --technique input or none, not with " +
                      technique.name);
  technique.ordering =
      std::make_shared<Ordering>(read_ordering_file(path_of(settings.ordering), framework));
}

/// Part of an ensemble, whose other walkers run elsewhere.
void take_shard(const CommandLine& line, RunSettings& settings) {
  if (line.was_given("--walkers"))
    throw OptionError("--shard: is given in place of --walkers, not together with it");
  const std::string_view text = settings.shard;
  const std::size_t dots = text.find("..");
  const auto first = parse_integer(text.substr(0, dots));
  const auto last = dots == text.npos ? std::nullopt : parse_integer(text.substr(dots + 2));
  if (!first || !last || *first < 0 || *last < *first || *last - *first >= most_walkers)
    throw OptionError("--shard: expected FIRST..LAST, two walkers' numbers, at most " +
                      std::to_string(most_walkers) + " walkers, found " + quoted(text));
  settings.first_walker = *first;
  settings.walkers = *last - *first + 1;
}

void check_one_file(RunSettings& settings) {
  if (!is_ensemble(settings))
    throw OptionError("--one-file: is for several walkers; give --walkers or --shard");
  if (!settings.go_on.empty())
    throw OptionError("--one-file: such a file does not go on; --commits keeps what is done");
  settings.record.flush_seconds = std::numeric_limits<double>::infinity();
}

void check_record_forces(const RunSettings& settings) {
  if (settings.record_forces.empty() || !settings.forces.empty()) return;
  if (settings.run.perturb != "force")
    throw OptionError("--record-forces: a force file holds one force on one joint a step, which " +
                      settings.run.perturb + " is not; use --perturb force");
}

/// What a client does is kept, so that the run can be repeated; where a force file can hold it.
void name_live_forces(RunSettings& settings) {
  const bool can_be_kept =
      settings.guide.empty() && (settings.run.perturb == "force" || !settings.forces.empty());
  if (!settings.imd.is_asked || !settings.record_forces.empty() || !can_be_kept) return;
  settings.record_forces = path_text(path_of(settings.output).replace_extension(".forces"));
  settings.imd.keeps_forces_if_pulled = true;
}

}  // namespace

void add_run_options(CommandLine& line, RunSettings& settings) {
  add_molecule_options(line, settings.molecule);
  line.start_group("Run");
  add_fields(line, settings.run, "Run");
  line.add_text("--continue", settings.go_on, "FILE",
                "continue the run in this trajectory, up to --steps in total, as if it had never "
                "stopped");
  line.not_required_with("input", "--continue");
  line.add_integer("--walkers", settings.walkers, 1, most_walkers,
                   "independent copies, each with its own output");
  line.add_text("--shard", settings.shard, "FIRST..LAST",
                "run only these walkers, such as 800..899");
  line.add_flag("--one-file", settings.one_file,
                "one trajectory for all walkers, one after another; the observable walker tells\n"
                "them apart. A walker's frames wait in memory until it ends");
  add_commit_options(line, settings.commits);
  line.add_integer("--threads", settings.threads, 1, 4096, "threads that share the walkers",
                   "all cores");
  add_technique_options(line, settings);
  add_perturb_options(line, settings);
  add_guide_options(line, settings.guide);
  add_imd_options(line, settings.imd);
  add_output_options(line, settings);
}

void number_walkers(const CommandLine& line, RunSettings& settings) {
  check_guide(line, settings.guide, is_ensemble(settings));
  if (line.was_given("--shard")) take_shard(line, settings);
  check_imd(line, settings.imd, is_ensemble(settings));
  if (settings.one_file) check_one_file(settings);
  check_commits(line, settings.commits);
  go_on_from_commits(settings.commits, settings.record);
  if (!settings.one_file && !settings.commits.file.empty())
    throw OptionError("--commits: goes with --one-file; other trajectories have --continue");
}

void name_outputs(const CommandLine& line, RunSettings& settings) {
  number_walkers(line, settings);
  if (settings.output.empty()) settings.output = default_trajectory(settings.molecule.file);
  name_live_forces(settings);
  if (settings.topology.empty())
    settings.topology = settings.first_walker > 0 || is_pdb_name(settings.output)
                            ? "none"
                            : default_topology(settings.output, settings.molecule.file);
}

void complete(const CommandLine& line, RunSettings& settings, const Molecule& molecule) {
  const Framework& framework = molecule.framework;
  if (settings.threads == 0) settings.threads = std::thread::hardware_concurrency();
  check_record_forces(settings);
  settings.run.guide = guide_from(settings.guide, molecule);
  if (!settings.forces.empty()) take_forces(line, settings, molecule);
  if (!settings.ordering.empty()) take_ordering(line, settings, framework);
  const bool is_left_to_auto = !line.was_given("--technique") && settings.ordering.empty() &&
                               settings.run.technique.name == "auto";
  if (is_left_to_auto && line.was_given("--weighting")) settings.run.technique.name = "bfs_cycle";
}

bool is_ensemble(const RunSettings& settings) {
  return settings.walkers != 1 || !settings.shard.empty();
}

std::string of_walker(const RunSettings& settings, const std::string& name, std::int64_t walker) {
  if (!is_ensemble(settings)) return name;
  const fs::path path = path_of(name);
  const std::string numbered =
      path_text(path.stem()) + "-" + std::to_string(walker) + path_text(path.extension());
  return path_text(path.parent_path() / path_of(numbered));
}

std::string output_of(const RunSettings& settings, std::int64_t walker) {
  if (settings.one_file) return settings.output;
  return of_walker(settings, settings.output, walker);
}

std::vector<NamedParameter> parameters_of(const RunSettings& settings, const Framework& framework,
                                          std::int64_t walker) {
  RunOptions run = settings.run;
  run.resolve.walker = static_cast<std::uint64_t>(walker);
  std::vector<NamedParameter> values = pliant::parameters_of(run, framework);
  if (!settings.events.empty())
    for (auto& [path, value] : values)
      if (path == "run/perturb") value = std::string(events_perturbation);
  if (const std::string edits = edits_text(settings.events, framework); !edits.empty())
    values.emplace_back("run/edits", edits);
  if (settings.one_file) values.emplace_back("run/walkers", settings.walkers);
  values.insert(values.end(),
                {{"input/file", path_text(path_of(settings.molecule.file).filename())},
                 {"input/model", settings.molecule.model},
                 {"input/select", settings.molecule.select},
                 {"input/assembly", settings.molecule.assembly},
                 {"input/bars", path_text(path_of(bars_of(settings.molecule)).filename())},
                 {"input/lengths", settings.molecule.lengths},
                 {"input/pin", settings.molecule.pin},
                 {"input/distance_bonds", settings.molecule.guess_distances},
                 {"run/ordering", path_text(path_of(settings.ordering).filename())},
                 {"run/forces", path_text(path_of(settings.forces).filename())}});
  for (const auto& more : {pliant::parameters_of(settings.record, settings.save),
                           parameters_of(settings.molecule.kind), parameters_of(settings.guide)})
    values.insert(values.end(), more.begin(), more.end());
  return values;
}

}  // namespace pliant::app
