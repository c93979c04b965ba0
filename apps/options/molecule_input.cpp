// SPDX-License-Identifier: MIT
#include "options/molecule_input.hpp"

#include <algorithm>
#include <filesystem>

#include "options/molecule_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/prepare/select_part.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/stated_bars.hpp"
#include "pliant/record/xml/graph_xml.hpp"

namespace pliant::app {
namespace {

constexpr std::int64_t most_models = 1'000'000'000;
constexpr const char* molecules = "PDB, mmCIF, XYZ, SDF (also .gz, .bz2, .xz)";
constexpr const char* molecules_or_graph =
    "PDB, mmCIF, XYZ, SDF (also .gz, .bz2, .xz), or a graph (.xml)";

/// All bytes of the file, expanded.
std::string bytes_of(const MoleculeOptions& options) {
  try {
    return read_bytes(path_of(options.file),
                      static_cast<std::size_t>(options.max_input) * 1'000'000);
  } catch (const TooLargeError& error) {
    throw OptionError(std::string(error.what()) + "; --max-input allows more");
  }
}

/// Throws OptionError naming the first option that a graph has no use for.
void check_graph(const MoleculeOptions& options) {
  const auto refuse = [](const std::string& option, const char* reason) {
    throw OptionError(option + ": is for molecules; a graph XML file " + reason);
  };
  constexpr const char* own_bars = "has bars of its own (--bars takes a bars file)";
  if (!options.kind.name.empty()) refuse("--model " + options.kind.name, own_bars);
  if (bars_of(options) != "bonds" && !is_bars_file(bars_of(options)))
    refuse("--bars " + options.bars, own_bars);
  for (const MoleculeField& field : molecule_fields())
    if (field.option != std::string_view("--pin") &&
        molecule_field_text(options, field) != molecule_field_text({}, field))
      refuse(field.option, "has joints and bars as they stand");
}

/// A graph XML file: its joints and bars as they stand, each bar shown as a bond of the file.
Molecule load_graph(const MoleculeOptions& options, const Log& log) {
  check_graph(options);
  const std::string bytes = bytes_of(options);
  GraphFile graph = parse_graph_xml({options.file, without_byte_order_mark(bytes)}, log);
  if (is_bars_file(bars_of(options)))
    graph.framework = with_stated_bars(graph.framework, graph.positions, path_of(options.bars));
  if (!options.pin.empty())
    graph.framework =
        graph.framework.with_pinned(select_joints(graph.framework, options.pin, "--pin"));
  Structure structure;
  structure.source = options.file;
  structure.format = "graph";
  structure.atoms = *graph.framework.atoms();
  structure.positions = std::move(graph.positions);
  for (Bar bar : graph.framework.bars())
    structure.bonds.push_back(
        {std::min(bar.a, bar.b), std::max(bar.a, bar.b), BondOrigin::file, 0});
  const std::uint64_t read = fingerprint(structure.atoms, structure.positions);
  return {std::move(structure), std::move(graph.framework), read};
}

/// A model says itself what its bars are and that they are as long as in the file.
void check(const MoleculeOptions& options) {
  pliant::app::check(options.kind);
  if (options.kind.name.empty()) return;
  if (!options.bars.empty())
    throw OptionError("--model, --bars: expected one of them: a model has bars of its own");
  if (options.lengths != "geometry")
    throw OptionError("--lengths " + options.lengths +
                      ": goes with --bars: a model has the lengths of the file");
}

Molecule load_model(const MoleculeOptions& options, const Structure& structure, const Log& log) {
  ModelOptions building = model_options_of(options.kind, log);
  building.pin = options.pin;
  building.may_be_cut = options.may_be_cut;
  MolecularModel model = build_model(structure, building);
  return {std::move(model.structure), std::move(model.framework),
          fingerprint(structure.atoms, structure.positions), std::move(model.left_out)};
}

void add_options_of_files(CommandLine& line, MoleculeOptions& options, const char* formats_taken) {
  line.start_group("Molecule");
  line.add_required_text("input", options.file, "FILE", formats_taken);
  line.add_choice("--format", options.format, names_of(formats()),
                  "pdb, mmcif, xyz or sdf (default: by extension or content)");
  line.add_integer("--frame", options.model, 1, most_models,
                   "which model, frame or record of the file");
  line.add_text("--assembly", options.assembly, "N",
                "build biological assembly N, as the file describes it");
  line.add_text("--select", options.select, "SELECTION",
                "use only these atoms, such as \"protein\" or \"not resname HOH\"");
  line.add_integer("--max-input", options.max_input, 1, largest_text / 1'000'000,
                   "largest file accepted, in megabytes, also once it is decompressed");
  line.add_opposite("--no-distance-bonds", options.guess_distances,
                    "do not guess bonds from distances");
}

}  // namespace

bool is_graph(const MoleculeOptions& options) {
  return options.format.empty() && path_of(options.file).extension() == ".xml";
}

std::string bars_of(const MoleculeOptions& options) {
  if (!options.bars.empty()) return options.bars;
  return options.kind.name.empty() ? "bonds" : options.kind.name;
}

void add_file_options(CommandLine& line, MoleculeOptions& options, bool takes_graphs) {
  add_options_of_files(line, options, takes_graphs ? molecules_or_graph : molecules);
}

void add_molecule_options(CommandLine& line, MoleculeOptions& options) {
  add_options_of_files(line, options, molecules_or_graph);
  line.add_integer_or_choice(
      "--model", options.model, 1, most_models, options.kind.name, names_of(models()),
      "what holds it together: bonds, angles, molecule (no overlaps) or "
      "protein (contacts, too); replaces --bars; a number is taken as --frame");
  line.add_text("--bars", options.bars, "NAME or FILE",
                "bars: bonds, angles (bonds, angles and planar groups), none, or a bars file "
                "(default: bonds)");
  line.add_choice("--lengths", options.lengths, names_of(length_choices),
                  "lengths of the bars: as in the file (geometry), or from a table of bonds");
  line.add_text("--pin", options.pin, "SELECTION",
                "atoms that never move, such as \"chainID A and name CA\"");
  add_model_options(line, options.kind);
}

Structure read(const MoleculeOptions& options, const Log& log) {
  ReadOptions reading;
  reading.model = static_cast<std::size_t>(options.model);
  reading.format = options.format;
  reading.assembly = options.assembly;
  reading.log = log;
  const std::string bytes = bytes_of(options);
  Structure structure = read_structure(SourceText{options.file, bytes}, reading);
  BondOptions bonding;
  bonding.guess_distances = options.guess_distances;
  bonding.log = log;
  perceive_bonds(structure, bonding);
  return options.select.empty() ? structure : select_part(structure, options.select, log);
}

Molecule load(const MoleculeOptions& options, const Log& log) {
  if (is_graph(options)) return load_graph(options, log);
  check(options);
  Structure structure = read(options, log);
  if (!options.kind.name.empty()) return load_model(options, structure, log);
  BuildOptions building;
  take_bars(bars_of(options), structure, building);
  building.lengths = choose(length_choices, "source of lengths", options.lengths).source;
  building.pin = options.pin;
  building.may_be_cut = options.may_be_cut;
  building.log = log;
  Framework framework = build_framework(structure, building);
  const std::uint64_t read = fingerprint(structure.atoms, structure.positions);
  return {std::move(structure), std::move(framework), read};
}

std::vector<std::string> inputs_of(const MoleculeOptions& options) {
  const bool has_bars_file = is_bars_file(bars_of(options));
  return {options.file, has_bars_file ? options.bars : "", options.kind.contacts};
}

}  // namespace pliant::app
