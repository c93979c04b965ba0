// SPDX-License-Identifier: MIT
// pliant run: the main job. A molecule in, an H5MD trajectory out.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "command.hpp"
#include "commands/continue_run.hpp"
#include "commands/run_walkers.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/force_header_input.hpp"
#include "output/print_run.hpp"
#include "pliant/base/error.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {

std::vector<std::string> outputs_of(const RunSettings& settings) {
  std::vector<std::string> outputs;
  if (settings.job.output.topology != "none") outputs.push_back(settings.job.output.topology);
  const std::int64_t first = settings.job.walkers.first;
  for (std::int64_t walker = first; walker < first + settings.job.walkers.walkers; ++walker) {
    if (!settings.job.walkers.one_file || walker == first)
      outputs.push_back(output_of(settings, walker));
    if (!settings.job.walkers.record_forces.empty())
      outputs.push_back(of_walker(settings, settings.job.walkers.record_forces, walker));
  }
  return outputs;
}

/// Asked before a file is opened: no output is an input or another output.
void check_outputs(const RunSettings& settings) {
  std::vector<std::string> inputs = inputs_of(settings.job.molecule);
  inputs.insert(inputs.end(), {settings.job.walkers.forces, settings.job.walkers.ordering});
  refuse_same_files(inputs, {settings.job.output.output});
  check_trajectory_name(settings.job.output.output, false);
  refuse_same_files(inputs, outputs_of(settings));
}

/// Bars of bonds leave a molecule far more freedom than it has.
void tell_what_is_free(const MoleculeOptions& options, const Structure& structure, const Log& log) {
  const bool is_molecule =
      structure.format != "graph" && usual_model(structure) == ModelKind::protein;
  if (is_molecule && options.model.model.empty() && bars_of(options) == "bonds")
    log.note(
        "only bonds are held: angles and planar groups are free, contacts may break, atoms may "
        "overlap; --model protein prevents this, and pliant sample makes ensembles");
}

/// Null where nobody looks.
std::unique_ptr<LiveRun> live_run(const RunSettings& settings, const Molecule& molecule,
                                  const Log& log) {
  if (!settings.imd.is_asked) return nullptr;
  if (settings.job.walkers.record_forces.empty())
    log.warn("clients can pull, but a force file cannot describe this run: it cannot be repeated");
  return std::make_unique<LiveRun>(settings.imd, settings.job.run, molecule.framework.joint_count(),
                                   log);
}

constexpr const char* footer =
    "Examples:\n"
    "  pliant run caffeine.sdf\n"
    "  pliant run protein.pdb -o out.h5md --steps 10000 --every 10 --technique blocks\n"
    "  pliant run protein.pdb -o movie.pdb --every 10\n"
    "  pliant run protein.pdb --perturb displacement --pin \"chainID A\" --walkers 8\n"
    "  pliant run protein.pdb --model protein --rock 1 --rock-amplitude 2\n"
    "  pliant run protein.pdb --model protein --pull \"resid 30:40\" 0,0,8\n"
    "  pliant run protein.pdb --model protein \\\n"
    "      --pair-distance \"resid 12 and name CA\" \"resid 88 and name CA\" 20..25\n"
    "  pliant run --continue out.h5md                after its end, Ctrl-C or a crash\n"
    "  pliant run --continue out.h5md --steps 20000\n"
    "Exit codes: 0 done, 1 bad input or file, 2 bad option, 3 a step did not converge or a\n"
    "guide did not reach its goal, 130 ended early by Ctrl-C, with all frames complete.";

/// Outputs by their names; inputs by the options and by what a force file was made for.
void take_names(const CommandLine& line, RunSettings& settings) {
  settle(line, settings);
  check_outputs(settings);
  take_force_header(line, settings);
  check_outputs(settings);  // of inputs that the header names, too
}

int print_end(const RunSettings& settings, const Molecule& molecule, const Messages& messages,
              const std::vector<RunSummary>& summaries, const GuideEnd& end,
              const std::optional<ImdSummary>& served) {
  if (settings.printing.json) {
    print_run_json(settings, molecule.framework, summaries, messages.warnings(), end, served);
  } else if (!settings.printing.quiet) {
    print_run_table(settings, molecule.framework, summaries);
    if (served) print_served(*served);
    end.print();
  }
  const int code = exit_code_of(added_up(summaries));
  return code == exit_ok && !end.is_reached() ? exit_unconverged : code;
}

int begin(CommandLine& line, RunSettings& settings) {
  const bool asks_for_topology = !settings.job.output.topology.empty();
  take_names(line, settings);
  Messages messages(settings.printing.json || settings.printing.quiet);
  Job& job = settings.job;
  const Molecule molecule = load_molecule(
      job.molecule, messages.log_of_model(job.molecule.input.file, settings.printing.verbose));
  job.molecule.model.model = molecule.model;
  messages.end_model(molecule.left_out);
  tell_what_is_free(job.molecule, molecule.structure, messages.log());
  check_force_header(settings, molecule, messages.log());
  complete(line, settings, molecule);
  OutputOptions& output = job.output;
  output.record.saved = select_joints(molecule.framework, output.save, "--save");
  refuse_to_replace(outputs_of(settings), output);
  warn_if_doubtful(job.run.technique, molecule.framework, messages.log());
  output.record.log = messages.log();
  output.topology = fitting_topology(output.topology, asks_for_topology, molecule.framework,
                                     molecule.structure.positions, output.record);
  if (settings.printing.dry_run) return print_forces(settings), exit_ok;
  watch_for_interrupt();
  std::vector<Vec3> last = molecule.structure.positions;
  const auto live = live_run(settings, molecule, messages.log());
  const std::vector<RunSummary> summaries =
      run_walkers(settings, molecule, messages.log(), last, live.get());
  std::optional<ImdSummary> served;
  if (live) served = live->close();
  const GuideEnd end(settings.job.guide, settings.job.run.guide, molecule.structure.positions,
                     last);
  return print_end(settings, molecule, messages, summaries, end, served);
}

}  // namespace

int command_run(const Arguments& arguments) {
  CommandLine line(
      "pliant run",
      "Pushes a molecule again and again, restores what each push breaks, and records every\n"
      "step in an H5MD trajectory.\n"
      "\n"
      "Atoms are joints. A bar is two joints at a fixed distance: a bond or, with --bars\n"
      "angles, the two ends of a bond angle. A push breaks bars. A technique resolves them:\n"
      "it makes them whole again, each at its length within the tolerance. Most techniques\n"
      "do so in sweeps, visits to all bars one after another. How far a bar is off is its\n"
      "residual; if one is beyond the tolerance, the frame and the exit code (3) say so. A\n"
      "walker is one of several independent copies of the molecule.");
  line.set_footer(footer);
  RunSettings settings;
  add_run_options(line, settings);
  line.set_common(
      {"--model", "--steps", "--technique", "--perturb", "--pull", "--pair-distance", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  return with_errors_as_json(!settings.printing.job_file.empty(), [&] {
    take_job_file(line, settings.job, settings.printing.job_file);
    return settings.job.go_on.empty() ? begin(line, settings) : continue_run(line, settings);
  });
}

}  // namespace pliant::app
