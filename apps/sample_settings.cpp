// SPDX-License-Identifier: MIT
#include "sample_settings.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <thread>

#include "pliant/base/choices.hpp"
#include "pliant/model/residue_nodes.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/sample/elastic_network.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;
constexpr std::int64_t most_frames = 100'000'000;

void add_molecule_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Molecule");
  line.add_required_text("input", settings.file, "FILE", "PDB, mmCIF, XYZ, SDF (may be gzipped)");
  line.add_choice("--format", settings.format, names_of(formats()),
                  "pdb, mmcif, xyz or sdf, if not told by extension or content");
  line.add_integer("--structure", settings.structure, 1, most_frames,
                   "which model, frame or record of the file");
  std::vector<std::string_view> kinds{"auto"};
  for (const ModelEntry& row : models()) kinds.push_back(row.name);
  line.add_choice("--model", settings.model, kinds,
                  "what holds the molecule; auto: protein for residues, else molecule");
  line.add_real("--hbond-cutoff", settings.building.hydrogen_bonds.cutoff, Range::any,
                "hydrogen bonds below this energy are held (kcal/mol)");
  line.add_text("--contacts", settings.building.contacts_file, "FILE",
                "contacts of this file in place of those found");
  line.add_flag("--keep-waters", settings.building.prepare.keep_waters, "leave waters in");
  line.add_names("--protonate", settings.building.prepare.protonate, "pH 7 by table",
                 "residues and their forms, such as HIS57:HID");
  line.add_opposite("--no-distance-bonds", settings.guess_distances,
                    "guess no bond from a distance");
}

void add_sample_group(CommandLine& line, SampleSettings& settings) {
  line.start_group("Sampling");
  SampleOptions& sample = settings.sample;
  line.add_integer("--frames", sample.frames, 1, most_frames, "frames to write");
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
                "H5MD trajectory (default: INPUT's name.h5md)");
  line.add_text("--topology", settings.topology, "FILE",
                "PDB with names and bonds, or none (default: OUTPUT's name.pdb)");
  line.add_flag("--overwrite", settings.record.overwrite, "replace existing outputs");
  line.add_flag("--single", settings.record.single, "positions as 32-bit floats");
  line.add_flag("--compress", settings.record.compress, "shuffle and gzip positions");
  line.add_flag("--json", settings.json, "print the summary as one JSON object");
  line.add_flag("--quiet", settings.quiet, "print nothing but errors");
}

fs::path stem_of(const fs::path& input) {
  fs::path name = input.filename();
  if (name.extension() == ".gz") name = name.stem();
  return name.stem();
}

/// Beside the output and of its name; "mol-topology.pdb" where mol.pdb is the input.
std::string default_topology(const SampleSettings& settings) {
  const fs::path beside = fs::path(settings.output).replace_extension(".pdb");
  std::error_code error;
  if (!fs::equivalent(beside, settings.file, error)) return beside.string();
  return (beside.parent_path() / (beside.stem().string() + "-topology.pdb")).string();
}

}  // namespace

void add_sample_options(CommandLine& line, SampleSettings& settings) {
  add_molecule_group(line, settings);
  add_sample_group(line, settings);
  add_output_group(line, settings);
}

void complete(SampleSettings& settings) {
  if (settings.threads == 0)
    settings.threads = std::max(1U, std::thread::hardware_concurrency());
  settings.sample.threads = static_cast<int>(settings.threads);
  if (settings.output.empty()) settings.output = stem_of(settings.file).string() + ".h5md";
  if (settings.topology.empty()) settings.topology = default_topology(settings);
  check(settings.sample);
}

MolecularModel load_model(const SampleSettings& settings, const Log& log) {
  Structure structure = read_structure(
      settings.file, {static_cast<std::size_t>(settings.structure), settings.format, log});
  BondOptions bonding;
  bonding.guess_distances = settings.guess_distances;
  bonding.log = log;
  perceive_bonds(structure, bonding);
  ModelOptions building = settings.building;
  building.kind = usual_model(structure);
  for (const ModelEntry& row : models())
    if (row.name == settings.model) building.kind = row.kind;
  building.log = log;
  return build_model(structure, building);
}

NetworkNodes nodes_of(const MolecularModel& model) {
  ResidueNodes found = residue_nodes(model.structure);
  NetworkNodes nodes;
  for (std::uint32_t atom : found.atoms) nodes.positions.push_back(model.positions[atom]);
  nodes.chain = std::move(found.chain);
  nodes.of_joint = std::move(found.of_atom);
  return nodes;
}

std::vector<NamedParameter> parameters_of(const SampleSettings& settings,
                                          const MolecularModel& model) {
  const SampleOptions& sample = settings.sample;
  return {{"input/file", settings.file},
          {"input/model", settings.structure},
          {"model/kind", std::string(entry(model.kind).name)},
          {"model/hbond_cutoff", settings.building.hydrogen_bonds.cutoff},
          {"model/keep_waters", settings.building.prepare.keep_waters},
          {"sample/frames", sample.frames},
          {"sample/first_frame", sample.first_frame},
          {"sample/amplitude", sample.amplitude},
          {"sample/seed", std::to_string(sample.seed)},
          {"sample/network", sample.network},
          {"sample/sampler", sample.sampler},
          {"sample/temperature", sample.temperature}};
}

}  // namespace pliant::app
