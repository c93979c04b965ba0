// SPDX-License-Identifier: MIT
// pliant run: the main job. A molecule in, an H5MD trajectory out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "command.hpp"
#include "commands/continue_run.hpp"
#include "commands/run_walkers.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/force_header_input.hpp"
#include "output/frame_output.hpp"
#include "output/output_files.hpp"
#include "output/print_run.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {

std::vector<std::string> outputs_of(const RunSettings& settings) {
  std::vector<std::string> outputs;
  if (settings.topology != "none") outputs.push_back(settings.topology);
  const std::int64_t first = settings.first_walker;
  for (std::int64_t walker = first; walker < first + settings.walkers; ++walker) {
    if (!settings.one_file || walker == first) outputs.push_back(output_of(settings, walker));
    if (!settings.record_forces.empty())
      outputs.push_back(of_walker(settings, settings.record_forces, walker));
  }
  return outputs;
}

/// Asked before a file is opened: no output is an input or another output.
void check_outputs(const RunSettings& settings) {
  std::vector<std::string> inputs = inputs_of(settings.molecule);
  inputs.insert(inputs.end(), {settings.forces, settings.ordering});
  refuse_same_files(inputs, {settings.output});
  check_trajectory_name(settings.output);
  check_record_options(settings.output, settings.save, settings.record);
  refuse_same_files(inputs, outputs_of(settings));
}

/// Asked of all outputs before the first is made, so that none is left behind alone.
void refuse_to_replace(const RunSettings& settings) {
  if (settings.record.overwrite) return;
  for (const std::string& output : outputs_of(settings)) {
    std::error_code error;
    if (std::filesystem::is_regular_file(path_of(output), error))
      throw FileError(printable_name(output) + ": exists; --overwrite replaces it");
  }
}

/// Bars of bonds leave a molecule far more freedom than it has.
void tell_what_is_free(const MoleculeOptions& options, const Structure& structure, const Log& log) {
  const bool is_molecule =
      structure.format != "graph" && usual_model(structure) == ModelKind::protein;
  if (is_molecule && options.kind.name.empty() && bars_of(options) == "bonds")
    log.note(
        "only bonds are held: angles and planar groups are free, contacts may break, atoms may "
        "overlap; --model protein prevents this, and pliant sample makes ensembles");
}

/// Null where nobody looks.
std::unique_ptr<LiveRun> live_run(const RunSettings& settings, const Molecule& molecule,
                                  const Log& log) {
  if (!settings.imd.is_asked) return nullptr;
  if (settings.record_forces.empty())
    log.warn("clients can pull, but a force file cannot describe this run: it cannot be repeated");
  return std::make_unique<LiveRun>(settings.imd, settings.run, molecule.framework.joint_count(),
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
  name_outputs(line, settings);
  check_outputs(settings);
  take_force_header(line, settings);
  check_outputs(settings);  // of inputs that the header names, too
}

int print_end(const RunSettings& settings, const Molecule& molecule, const Messages& messages,
              const std::vector<RunSummary>& summaries, const GuideEnd& end,
              const std::optional<ImdSummary>& served) {
  if (settings.json) {
    print_run_json(settings, molecule.framework, summaries, messages.warnings(), end, served);
  } else if (!settings.quiet) {
    print_run_table(settings, molecule.framework, summaries);
    if (served) print_served(*served);
    end.print();
  }
  const int code = exit_code_of(added_up(summaries));
  return code == exit_ok && !end.is_reached() ? exit_unconverged : code;
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
  if (!settings.go_on.empty()) return continue_run(line, settings);
  const bool asks_for_topology = !settings.topology.empty();
  take_names(line, settings);
  Messages messages(settings.json || settings.quiet);
  const Molecule molecule =
      load(settings.molecule, messages.log_of_model(settings.molecule.file, settings.verbose));
  messages.end_model(molecule.left_out);
  tell_what_is_free(settings.molecule, molecule.structure, messages.log());
  check_force_header(settings, molecule, messages.log());
  complete(line, settings, molecule);
  settings.record.saved = select_joints(molecule.framework, settings.save, "--save");
  refuse_to_replace(settings);
  warn_if_doubtful(settings.run.technique, molecule.framework, messages.log());
  settings.record.log = messages.log();
  settings.topology = fitting_topology(settings.topology, asks_for_topology, molecule.framework,
                                       molecule.structure.positions, settings.record);
  if (settings.dry_run) return print_forces(settings), exit_ok;
  watch_for_interrupt();
  std::vector<Vec3> last = molecule.structure.positions;
  const auto live = live_run(settings, molecule, messages.log());
  const std::vector<RunSummary> summaries =
      run_walkers(settings, molecule, messages.log(), last, live.get());
  std::optional<ImdSummary> served;
  if (live) served = live->close();
  const GuideEnd end(settings.guide, settings.run.guide, molecule.structure.positions, last);
  return print_end(settings, molecule, messages, summaries, end, served);
}

}  // namespace pliant::app
