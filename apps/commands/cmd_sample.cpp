// SPDX-License-Identifier: MIT
// pliant sample: an ensemble of what a molecule can do. A molecule in, an H5MD trajectory out.
#include <algorithm>
#include <filesystem>
#include <optional>

#include "command.hpp"
#include "commands/committed_sample.hpp"
#include "commands/continue_sample.hpp"
#include "commands/show_sample.hpp"
#include "external.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/conformers_asked.hpp"
#include "options/sample_settings.hpp"
#include "output/frame_output.hpp"
#include "output/output_files.hpp"
#include "output/recorded_header.hpp"
#include "output/sample_report.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/recorded_sample.hpp"
#include "pliant/molecule/selection.hpp"

namespace pliant::app {
namespace {

/// A molecule that a sample has been planned of.
struct PlannedSample {
  const MolecularModel& model;
  const SampleTask& task;
};

H5mdHeader header_of(const SampleSettings& settings, const PlannedSample& planned) {
  H5mdHeader header = molecule_header(planned.model.structure);
  header.parameters = parameters_of(settings);
  header.parameters.push_back(left_out_of(planned.model));
  header.inputs = sample_inputs(planned.task.start(), planned.task.nodes());
  return header;
}

/// Asked of both outputs before the first is made, so that none is left behind alone.
void check_outputs(const SampleSettings& settings) {
  refuse_same_files(inputs_of(settings), {settings.output});
  check_show(settings);
  if (!is_sdf_name(settings.output)) check_trajectory_name(settings.output);
  check_record_options(settings.output, settings.save, settings.record);
  std::vector<std::string> outputs{settings.output};
  if (settings.topology != "none") outputs.push_back(settings.topology);
  refuse_same_files(inputs_of(settings), outputs);
  for (const std::string& output : outputs) {
    std::error_code error;
    if (!settings.record.overwrite && std::filesystem::is_regular_file(path_of(output), error))
      throw FileError(printable_name(output) + ": exists; --overwrite replaces it");
  }
}

SdfMolecule sdf_molecule(const Structure& structure) {
  return {structure.title, structure.charges, structure.isotopes, structure.radicals};
}

void refuse_single_node(const PlannedSample& planned) {
  if (planned.task.nodes().positions.size() < 2)
    throw InputError(at({planned.model.structure.source},
                        "holds one residue or atom: an ensemble needs two that can move apart"));
}

SampleSummary sample_to_file(const SampleSettings& settings, const PlannedSample& planned) {
  refuse_single_node(planned);
  const SampleTask& task = planned.task;
  const H5mdHeader header = header_of(settings, planned);
  std::optional<CommittedSample> committed;
  if (!settings.commits.file.empty()) committed.emplace(settings, task, header.parameters);
  FrameOutput recorder(settings.output, task.framework(), header, settings.record,
                       sdf_molecule(planned.model.structure));
  write_topology(settings.topology, task.framework(), header, planned.model.positions,
                 settings.record);
  ProgressBar progress(task.options().frames, "frames", settings.quiet);
  std::int64_t done = 0;
  const SampleObserver observer = [&](const Frame& frame) {
    recorder.record(frame);
    progress.show(++done);
    return interrupted();
  };
  SampleSummary summary = committed ? committed->run(observer) : task.run(observer, interrupted);
  recorder.close();
  if (committed) committed->end();
  return summary;
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

SampledSystem system_of(const PlannedSample& planned) {
  const MolecularModel& model = planned.model;
  return {entry(model.kind).name,
          planned.task.framework(),
          model.positions,
          model.contacts.size(),
          model.notes,
          model.missing,
          model.left_out,
          model.placed,
          counted_kinds(model.contacts)};
}

constexpr const char* sample_purpose =
    "Makes an ensemble: independent frames around the structure in the file, each with exact\n"
    "bonds and angles and no overlaps. Contacts are held. In about half of the frames of a\n"
    "larger protein (see --sampler) domains turn, and contacts between them are released.\n"
    "How far the frames go (--amplitude) is an input, not a prediction, and how often a shape\n"
    "occurs is not known.\n"
    "For a small molecule the frames are conformers, with new torsions and flipped rings.";

constexpr const char* sample_examples =
    "Examples:\n"
    "  pliant sample protein.pdb -o ensemble.h5md\n"
    "  pliant sample protein.pdb --show                    on a page, moving\n"
    "  pliant sample protein.cif --frames 1000 --amplitude 2 --seed 7\n"
    "  pliant sample protein.pdb --amplitude nmr_models.pdb\n"
    "  pliant sample protein.pdb --sampler dilute --hbond-cutoff -2\n"
    "  pliant sample drug.sdf --frames 200                 torsions, rings\n"
    "  pliant sample library.sdf -o conformers.sdf         ranked: see pliant conformers\n"
    "  pliant sample --continue ensemble.h5md              after Ctrl-C or a crash\n"
    "  pliant sample --continue ensemble.h5md --frames 2000\n"
    "Exit codes: 0 done, 1 bad input or file, 2 bad option, 3 a frame could not be made and\n"
    "is left out, 130 ended early by Ctrl-C, with all frames complete.";

}  // namespace

int command_sample(const Arguments& arguments) {
  if (asks_for_conformers(arguments)) return run_program("conformers", arguments);
  CommandLine line("pliant sample", sample_purpose);
  line.set_footer(sample_examples);
  SampleSettings settings;
  add_sample_options(line, settings);
  line.set_common({"--frames", "--amplitude", "--continue", "--select", "--keep", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  if (!settings.go_on.empty()) return continue_sample(line, settings);
  Messages messages(settings.json || settings.quiet);
  const bool asks_for_topology = !settings.topology.empty();
  check_commits(line, settings.commits);
  go_on_from_commits(settings.commits, settings.record);
  complete(settings);
  check_outputs(settings);
  settings.record.log = messages.log();
  settings.sample.log = messages.log();
  const MolecularModel model =
      load_model(settings, messages.log_of_model(settings.molecule.file, settings.verbose));
  messages.end_model({});  // the report says what is left out
  const SampleTask task(subject_of(model), asked_of(settings, model, messages.log()));
  settings.sample = task.options();
  settings.record.saved = select_joints(task.framework(), settings.save, "--save");
  settings.topology = fitting_topology(settings.topology, asks_for_topology, task.framework(),
                                       model.positions, settings.record);
  if (settings.dry_run) return exit_ok;
  watch_for_interrupt();
  const PlannedSample planned{model, task};
  const SampleSummary summary = sample_to_file(settings, planned);
  warn_of_amplitude(summary, messages.log());
  print_sample(settings, system_of(planned), summary, messages.warnings());
  return shown(settings, exit_code_of(summary));
}

}  // namespace pliant::app
