// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/molecule_input.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/stated_bars.hpp"
#include "pliant/record/xml/graph_xml.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Bars";

template <auto Member>
constexpr auto at = place_at<BarsAsked, Member>;

constexpr OptionField<BarsAsked> table[] = {
    {{.name = "bars",
      .group = group,
      .summary = "bars: bonds, angles (bonds, angles and planar groups), none, or a bars file "
                 "(default: bonds); in place of --model",
      .kind = "NAME or FILE",
      .is_file = true,
      .in_python = "Bars: bonds, angles (bonds, angles and planar groups), none, or a bars file; "
                   "empty: bonds.",
      .type_in_python = "str | os.PathLike[str]"},
     at<&BarsAsked::bars>},
    {{.name = "pin",
      .group = group,
      .summary = "atoms that never move, such as \"chainID A and name CA\"",
      .kind = "SELECTION"},
     at<&BarsAsked::pin>},
};

/// Throws OptionError naming the first option that a graph has no use for.
void check_graph(const MoleculeOptions& options) {
  const auto refuse = [](const std::string& option, const char* reason) {
    throw OptionError(option + ": is for molecules; a graph XML file " + reason);
  };
  constexpr const char* own_bars = "has bars of its own (--bars takes a bars file)";
  if (!options.model.model.empty()) refuse("--model " + options.model.model, own_bars);
  if (bars_of(options) != "bonds" && !is_bars_file(bars_of(options)))
    refuse("--bars " + options.bars.bars, own_bars);
  constexpr std::string_view taken[] = {"pin", "bars", "max_input"};
  MoleculeOptions given = options, usual;
  for (const auto& row : molecule_rows())
    if (std::ranges::find(taken, row.facts->name) == std::end(taken) &&
        option_text(row.place(given)) != option_text(row.place(usual)))
      refuse(option_name(*row.facts), "has joints and bars as they stand");
}

/// A graph XML file: its joints and bars as they stand, each bar shown as a bond of the file.
Molecule load_graph(const MoleculeOptions& options, const Log& log) {
  check_graph(options);
  const std::string bytes = input_bytes(options.input);
  GraphFile graph = parse_graph_xml({options.input.file, without_byte_order_mark(bytes)}, log);
  if (is_bars_file(bars_of(options)))
    graph.framework =
        with_stated_bars(graph.framework, graph.positions, path_of(options.bars.bars));
  if (!options.bars.pin.empty())
    graph.framework =
        graph.framework.with_pinned(select_joints(graph.framework, options.bars.pin, "--pin"));
  Structure structure;
  structure.source = options.input.file;
  structure.format = "graph";
  structure.atoms = *graph.framework.atoms();
  structure.positions = std::move(graph.positions);
  for (Bar bar : graph.framework.bars())
    structure.bonds.push_back(
        {std::min(bar.a, bar.b), std::max(bar.a, bar.b), BondOrigin::file, 0});
  const std::uint64_t read = fingerprint(structure.atoms, structure.positions);
  return {std::move(structure), std::move(graph.framework), read};
}

/// A model says itself what its bars are.
void check_bars(const MoleculeOptions& options) {
  if (!options.model.model.empty() && !options.bars.bars.empty())
    throw OptionError("--model, --bars: expected one of them: a model has bars of its own");
}

/// Steps heed no torsion preferences.
Molecule load_model(const MoleculeOptions& options, const Structure& structure, const Log& log) {
  ModelOptions building =
      model_options_of(options.model, kind_of_model(options.model, structure), log);
  building.torsions = false;
  building.pin = options.bars.pin;
  building.may_be_cut = options.may_be_cut;
  MolecularModel model = build_model(structure, building);
  return {std::move(model.structure), std::move(model.framework),
          fingerprint(structure.atoms, structure.positions), std::move(model.left_out),
          std::string(entry(model.kind).name)};
}

Molecule load_bars(const MoleculeOptions& options, Structure structure) {
  BuildOptions building;
  take_bars(bars_of(options), structure, building);
  building.pin = options.bars.pin;
  building.may_be_cut = options.may_be_cut;
  Framework framework = build_framework(structure, building);
  const std::uint64_t read = fingerprint(structure.atoms, structure.positions);
  return {std::move(structure), std::move(framework), read};
}

}  // namespace

std::span<const OptionField<BarsAsked>> bars_fields() { return table; }

std::span<const OptionRow<MoleculeOptions>> molecule_rows() {
  static const std::vector<OptionRow<MoleculeOptions>> rows = [] {
    using M = MoleculeOptions;
    std::vector<OptionRow<M>> all;
    append_rows(all, "input", input_fields(), [](M& m) -> InputOptions& { return m.input; });
    append_rows(all, "input", bars_fields(), [](M& m) -> BarsAsked& { return m.bars; });
    append_rows(all, "model", model_fields(), [](M& m) -> ModelAsked& { return m.model; });
    return all;
  }();
  return rows;
}

RunSubject subject_of(const Molecule& molecule) {
  return {molecule.framework, molecule.structure.positions, &molecule.structure,
          molecule.fingerprint, molecule.model};
}

std::string bars_of(const MoleculeOptions& options) {
  if (!options.bars.bars.empty()) return options.bars.bars;
  return options.model.model.empty() ? "bonds" : options.model.model;
}

bool is_graph(const MoleculeOptions& options) {
  return path_of(options.input.file).extension() == ".xml";
}

Molecule load_molecule(const MoleculeOptions& options, const Log& log) {
  if (is_graph(options)) return load_graph(options, log);
  check_bars(options);
  const std::string& name = options.model.model;
  const bool is_named = !name.empty() && name != automatic_model;
  if (name != automatic_model)
    check(options.model, is_named ? &choose(models(), "model", name) : nullptr, "--");
  Structure structure = read_input(options.input, log);
  if (name.empty()) return load_bars(options, std::move(structure));
  check(options.model, &entry(kind_of_model(options.model, structure)), "--");
  return load_model(options, structure, log);
}

std::vector<std::string> inputs_of(const MoleculeOptions& options) {
  const bool has_bars_file = is_bars_file(bars_of(options));
  return {options.input.file, has_bars_file ? options.bars.bars : "", options.model.contacts};
}

ForceHeader force_header_of(const MoleculeOptions& options, const RunSubject& subject) {
  ForceHeader header = force_header_of(subject.framework);
  header.structure = subject.fingerprint;
  const bool has_model = !options.model.model.empty();
  const bool is_said = has_model || !subject.is_graph() || !options.bars.bars.empty();
  if (is_said) header.input.push_back({has_model ? "model" : "bars", bars_of(options)});
  MoleculeOptions given = options, usual;
  for (const auto& row : molecule_rows()) {
    if (!row.facts->users.file || row.facts->name == "model" || row.facts->name == "bars") continue;
    const std::string text = option_text(row.place(given));
    if (text != option_text(row.place(usual)))
      header.input.push_back({std::string(row.facts->name), text});
  }
  return header;
}

}  // namespace pliant
