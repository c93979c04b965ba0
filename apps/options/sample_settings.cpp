// SPDX-License-Identifier: MIT
#include "options/sample_settings.hpp"

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "messages.hpp"
#include "options/option_fields.hpp"
#include "output/frame_output.hpp"
#include "output/output_files.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/asked_amplitude.hpp"
#include "pliant/model/prepare/largest_molecule.hpp"
#include "pliant/molecule/drawing.hpp"

namespace pliant::app {
namespace {

std::int64_t all_cores() { return std::max(1U, std::thread::hardware_concurrency()); }

void add_molecule_group(CommandLine& line, SampleSettings& settings) {
  add_file_options(line, settings.molecule);
  std::vector<std::string_view> kinds{"auto"};
  for (const ModelEntry& row : models()) kinds.push_back(row.name);
  line.add_choice("--model", settings.model, kinds,
                  "what holds it together; auto: protein if there are residues, else molecule");
  add_model_options(line, settings.molecule.kind);
  settings.molecule.kind.has_torsions = true;
  add_torsion_option(line, settings.molecule.kind);
}

void add_continue(CommandLine& line, SampleSettings& settings) {
  line.add_text("--continue", settings.go_on, "FILE",
                "continue this trajectory, up to --frames in total, as if it had never "
                "stopped");
  line.not_required_with("input", "--continue");
}

void add_amplitude(CommandLine& line, SampleSettings& settings) {
  line.add_text("--amplitude", settings.amplitude, "X, NAME or FILE",
                "how far frames go: r.m.s. fluctuation, averaged over residues. An input:\n"
                "X: in Angstrom (default " +
                    number_text(usual_amplitude) +
                    ", which is that of ubiquitin by NMR, 2K39)\n"
                    "bfactors: from the B factors in the file, sqrt(3 B / 8 pi^2)\n"
                    "FILE: from your own ensemble: models (PDB, mmCIF) or frames (H5MD) of the\n"
                    "same residues, with the same numbers");
}

void add_sample_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Sampling");
  settings.sample.threads = all_cores();
  for (const SampleField& field : sample_fields()) {
    if (field.users.command) add_option(line, field, field.place(settings.sample));
    if (field.name == "frames") {
      add_continue(line, settings);
      add_commit_options(line, settings.commits);
    }
    if (field.name == "amplitude") add_amplitude(line, settings);
  }
}

void add_output_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FILE",
                "H5MD trajectory, or a PDB file (.pdb) of all frames, or an SDF file (.sdf): of\n"
                "ranked conformers, or with --sampler torsions of all frames\n"
                "(default: INPUT's name.h5md)");
  line.add_text("--topology", settings.topology, "FILE",
                "PDB file of names and bonds to write, or none (default: OUTPUT's name.pdb)");
  line.add_flag("--overwrite", settings.record.overwrite, "replace existing outputs");
  line.add_flag("--single", settings.record.single, "positions as 32-bit floats");
  line.add_flag("--compress", settings.record.compress, "shuffle and gzip positions");
  add_saving_options(line, settings.save, settings.record);
  line.add_flag("--show", settings.show,
                "then open the frames on a page in the browser: pliant play OUTPUT");
  line.add_flag("--dry-run", settings.dry_run,
                "read the input, check all options, and write nothing");
  line.add_flag("--json", settings.json, "print the summary as one JSON object");
  line.add_flag("--quiet", settings.quiet, "print nothing but errors");
  add_verbose(line, settings.verbose);
}

/// What was asked for, in one way of writing: for files, and to compare with what they hold.
std::string amplitude_source(const SampleSettings& settings) {
  if (settings.amplitude.empty()) return number_text(usual_amplitude);
  const auto number = parse_real(settings.amplitude);
  return number ? number_text(*number) : settings.amplitude;
}

/// A number is refused before any file is read.
void check_amplitude(const SampleSettings& settings) {
  const auto number = parse_real(settings.amplitude);
  if (number && !(*number > 0.0))
    throw OptionError("--amplitude: expected a number above 0, found " +
                      pliant::quoted(settings.amplitude));
}

}  // namespace

void add_sample_options(CommandLine& line, SampleSettings& settings) {
  add_molecule_group(line, settings);
  add_sample_group(line, settings);
  add_output_group(line, settings);
}

void complete(SampleSettings& settings) {
  if (settings.output.empty()) settings.output = default_trajectory(settings.molecule.file);
  if (settings.topology.empty())
    settings.topology = is_pdb_name(settings.output) || is_sdf_name(settings.output)
                            ? "none"
                            : default_topology(settings.output, settings.molecule.file);
  check_amplitude(settings);
  SampleOptions known = settings.sample;
  if (known.sampler == automatic_sampler) known.sampler = SampleOptions{}.sampler;
  if (known.frames == open_frames) known.frames = SampleOptions{}.frames;
  check(known);
}

MolecularModel load_model(SampleSettings& settings, const Log& log) {
  Structure structure = read(settings.molecule, log);
  refuse_drawing(structure);
  if (usual_model(structure) == ModelKind::molecule) structure = largest_molecule(structure, log);
  settings.molecule.kind.name =
      settings.model == "auto" ? entry(usual_model(structure)).name : settings.model;
  check(settings.molecule.kind);
  return build_model(structure, model_options_of(settings.molecule.kind, log));
}

SampleAsked asked_of(SampleSettings& settings, const MolecularModel& model, const Log& log) {
  settings.chosen_amplitude = {usual_amplitude, number_text(usual_amplitude),
                               "the default; see --amplitude for others"};
  SampleAsked asked{settings.sample, std::nullopt, "--"};
  if (!settings.amplitude.empty()) {
    settings.chosen_amplitude = asked_amplitude(settings.amplitude, model.structure, log);
    asked.amplitude = settings.chosen_amplitude;
  }
  return asked;
}

std::vector<std::string> inputs_of(const SampleSettings& settings) {
  std::vector<std::string> all = inputs_of(settings.molecule);
  const bool is_file = !parse_real(settings.amplitude) && settings.amplitude != "bfactors";
  if (is_file) all.push_back(settings.amplitude);
  return all;
}

std::vector<NamedParameter> parameters_of(const SampleSettings& settings) {
  const MoleculeOptions& molecule = settings.molecule;
  std::vector<NamedParameter> all = pliant::parameters_of(settings.sample);
  all.insert(all.end(), {{"input/file", path_text(path_of(molecule.file).filename())},
                         {"input/model", molecule.model},
                         {"input/select", molecule.select},
                         {"input/assembly", molecule.assembly},
                         {"input/distance_bonds", molecule.guess_distances},
                         {"sample/amplitude_from", amplitude_source(settings)},
                         {"sample/amplitude_reason", settings.chosen_amplitude.reason},
                         {"model/free_torsions", molecule.kind.free_torsions}});
  for (const auto& more :
       {pliant::parameters_of(settings.record, settings.save), parameters_of(molecule.kind)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace pliant::app
