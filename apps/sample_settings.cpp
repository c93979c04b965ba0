// SPDX-License-Identifier: MIT
#include "sample_settings.hpp"

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "frame_output.hpp"
#include "output_files.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/laboratory/recorded_sample.hpp"
#include "pliant/model/residue_nodes.hpp"
#include "pliant/sample/elastic_network.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant::app {
namespace {

constexpr std::int64_t most_frames = 100'000'000;

void add_molecule_group(CommandLine& line, SampleSettings& settings) {
  add_file_options(line, settings.molecule);
  std::vector<std::string_view> kinds{"auto"};
  for (const ModelEntry& row : models()) kinds.push_back(row.name);
  line.add_choice("--model", settings.model, kinds,
                  "what holds it; auto: protein where there are residues, else molecule");
  add_model_options(line, settings.molecule.kind);
}

void add_sample_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Sampling");
  SampleOptions& sample = settings.sample;
  line.add_integer("--frames", sample.frames, 1, most_frames, "frames to write");
  line.add_text("--continue", settings.go_on, "FILE",
                "go on with the frames of a trajectory, up to --frames in all, as if it had never "
                "stopped");
  line.not_required_with("input", "--continue");
  line.add_integer("--first-frame", sample.first_frame, 0, most_frames,
                   "number of the first frame: a run may be made in pieces");
  line.add_real("--amplitude", sample.amplitude, Range::positive,
                "mean r.m.s. fluctuation of residues (Angstrom): an input, not a result");
  line.add_seed("--seed", sample.seed, "of all random numbers");
  line.add_integer("--threads", settings.threads, 1, 4096, "threads that share the frames",
                   "all cores");
  line.add_choice("--network", sample.network, names_of(networks()),
                  "elastic network whose modes frames go along");
  line.add_choice("--sampler", sample.sampler, names_of(samplers()), "way to move");
  line.add_real("--temperature", sample.temperature, Range::positive,
                "T of sampler dilute (kJ/mol)");
}

void add_output_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FILE",
                "H5MD trajectory, or models of a PDB file where the name ends in .pdb\n"
                "(default: INPUT's name.h5md)");
  line.add_text("--topology", settings.topology, "FILE",
                "PDB with names and bonds, or none (default: OUTPUT's name.pdb)");
  line.add_flag("--overwrite", settings.record.overwrite, "replace existing outputs");
  line.add_flag("--single", settings.record.single, "positions as 32-bit floats");
  line.add_flag("--compress", settings.record.compress, "shuffle and gzip positions");
  line.add_flag("--json", settings.json, "print the summary as one JSON object");
  line.add_flag("--quiet", settings.quiet, "print nothing but errors");
}

}  // namespace

void add_sample_options(CommandLine& line, SampleSettings& settings) {
  add_molecule_group(line, settings);
  add_sample_group(line, settings);
  add_output_group(line, settings);
}

int threads_of(const SampleSettings& settings) {
  const auto all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return settings.threads == 0 ? all : static_cast<int>(settings.threads);
}

void complete(SampleSettings& settings) {
  settings.sample.threads = threads_of(settings);
  if (settings.output.empty()) settings.output = default_trajectory(settings.molecule.file);
  if (settings.topology.empty())
    settings.topology = is_pdb_name(settings.output)
                            ? "none"
                            : default_topology(settings.output, settings.molecule.file);
  check(settings.sample);
}

MolecularModel load_model(SampleSettings& settings, const Log& log) {
  const Structure structure = read(settings.molecule, log);
  settings.molecule.kind.name =
      settings.model == "auto" ? entry(usual_model(structure)).name : settings.model;
  check(settings.molecule.kind);
  return build_model(structure, model_options_of(settings.molecule.kind, log));
}

NetworkNodes nodes_of(const MolecularModel& model) {
  ResidueNodes found = residue_nodes(model.structure);
  if (found.positions.size() < 2)
    throw InputError(at({model.structure.source},
                        "holds one residue or atom: an ensemble needs two that can move apart"));
  return {std::move(found.positions), std::move(found.chain), std::move(found.of_atom)};
}

std::vector<NamedParameter> parameters_of(const SampleSettings& settings) {
  const MoleculeOptions& molecule = settings.molecule;
  std::vector<NamedParameter> all = pliant::parameters_of(settings.sample);
  all.insert(all.end(), {{"input/file", std::filesystem::path(molecule.file).filename().string()},
                         {"input/model", molecule.model},
                         {"input/select", molecule.select},
                         {"input/assembly", molecule.assembly},
                         {"input/distance_bonds", molecule.guess_distances},
                         {"record/single", settings.record.single},
                         {"record/compress", settings.record.compress}});
  for (NamedParameter& one : parameters_of(molecule.kind)) all.push_back(std::move(one));
  return all;
}

}  // namespace pliant::app
