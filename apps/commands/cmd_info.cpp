// SPDX-License-Identifier: MIT
// pliant info: what a file holds, and what was guessed.
#include <fmt/format.h>

#include <map>
#include <set>

#include "command.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "output/json.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/model/prepare/additives.hpp"
#include "pliant/model/prepare/survey.hpp"
#include "pliant/molecule/planar_groups.hpp"

namespace pliant::app {
namespace {

/// What there is besides chains of residues with all their hydrogens.
std::vector<std::string> found_lines(const Structure& structure, const Survey& found) {
  std::vector<std::string> lines = found_parts(structure, found);
  if (found.waters > 0) lines.insert(lines.begin(), fmt::format("waters: {}", found.waters));
  if (const Additives additives = find_additives(structure, {}); !additives.out.empty())
    lines.push_back(fmt::format("molecules of crystallisation, which models leave out: {}",
                                counted_names(structure.atoms, additives.out)));
  return lines;
}

/// What there is not; of hydrogens, only what proteins and nucleic acids should have.
std::vector<std::string> missing_lines(const Structure& structure, const Survey& found) {
  std::vector<std::string> lines = missing_parts(structure, found);
  if (!found.without_hydrogens.empty())
    lines.insert(
        lines.begin(),
        fmt::format("hydrogens: of {} of {} residues (polar ones are placed by rule)",
                    found.without_hydrogens.size(), found.amino_acids + found.nucleotides));
  return lines;
}

/// How many there are of each name.
using Counts = std::vector<std::pair<std::string, std::size_t>>;

struct Facts {
  const MoleculeOptions& options;
  const Structure& structure;
  GraphFacts graph;
  std::size_t pinned;
  Counts elements, bonds_by_origin;
  std::size_t planar_bars;  ///< across bonds about which nothing turns
  std::size_t chains;
  Counts limits_by_kind;
  bool has_sterics;
  Survey survey;

  /// A graph XML file has joints and bars, and nothing of chemistry.
  bool has_atoms() const { return structure.format != "graph"; }
};

Counts elements_of(const Structure& structure) {
  std::map<std::uint8_t, std::size_t> counts;
  for (std::uint8_t element : structure.atoms.elements) ++counts[element];
  Counts named;
  for (const auto& [element, count] : counts) named.emplace_back(element_symbol(element), count);
  return named;
}

Counts bonds_by_origin(const Structure& structure) {
  Counts counts;
  for (const std::string_view name : bond_origin_names) counts.emplace_back(name, 0);
  for (const Bond& bond : structure.bonds) ++counts[static_cast<std::size_t>(bond.origin)].second;
  return counts;
}

Counts limits_by_kind(const Framework& framework) {
  Counts counts;
  for (const LimitKindEntry& row : limit_kinds()) counts.emplace_back(row.name, 0);
  for (const Limit& limit : framework.limits())
    ++counts[static_cast<std::size_t>(limit.kind)].second;
  return counts;
}

std::size_t chains_of(const Structure& structure) {
  std::set<std::string_view> chains;
  for (const Residue& residue : structure.atoms.residues) chains.insert(residue.chain);
  return chains.size();
}

/// Whether there are bars across bond angles: all models but that of bonds have them.
bool has_angles(const MoleculeOptions& options) {
  return bars_of(options) == "angles" ||
         (!options.model.model.empty() && options.model.model != "bonds");
}

Facts facts_of(const MoleculeOptions& options, const Molecule& molecule) {
  const Structure& structure = molecule.structure;
  const Framework& framework = molecule.framework;
  return {options,
          structure,
          graph_facts(framework),
          framework.pinned_count(),
          elements_of(structure),
          bonds_by_origin(structure),
          has_angles(options) ? find_planar_bars(structure).size() : 0,
          chains_of(structure),
          limits_by_kind(framework),
          framework.sterics() != nullptr,
          survey(structure)};
}

Json as_object(const Counts& counts) {
  return Json::object(std::vector<std::pair<std::string, Json>>(counts.begin(), counts.end()));
}

Json json_of_file(const Facts& facts) {
  const Structure& structure = facts.structure;
  return {{"file", facts.options.input.file},
          {"format", structure.format},
          {"title", structure.title},
          {"model", structure.model},
          {"models", structure.model_count}};
}

Json json_of_atoms(const Facts& facts) {
  return {{"atoms", facts.structure.size()},
          {"residues", facts.structure.atoms.residues.size()},
          {"chains", facts.chains},
          {"assemblies", facts.structure.assemblies},
          {"elements", as_object(facts.elements)},
          {"bonds", facts.structure.bonds.size()},
          {"bonds_by_origin", as_object(facts.bonds_by_origin)},
          {"bar_kind", bars_of(facts.options)},
          {"planar_bars", facts.planar_bars}};
}

Json json_of_survey(const Facts& facts) {
  const Survey& found = facts.survey;
  return {{"amino_acids", found.amino_acids},
          {"nucleotides", found.nucleotides},
          {"waters", found.waters},
          {"usual_model", entry(usual_model(facts.structure)).name},
          {"found", found_lines(facts.structure, found)},
          {"missing", missing_lines(facts.structure, found)}};
}

Json json_of_bars(const Facts& facts) {
  const GraphFacts& graph = facts.graph;
  return {{"joints", graph.joints},
          {"bars", graph.bars},
          {"pinned", facts.pinned},
          {"components", graph.components},
          {"cycles", graph.cycles},
          {"bridges", graph.bridges},
          {"blocks", graph.blocks},
          {"largest_block", graph.largest_block},
          {"bars_in_blocks", graph.bars_in_blocks}};
}

std::size_t sum_of(const Counts& counts) {
  std::size_t sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

Json json_of_limits(const Facts& facts) {
  return {{"limits", sum_of(facts.limits_by_kind)},
          {"limits_by_kind", as_object(facts.limits_by_kind)},
          {"sterics", facts.has_sterics}};
}

void print_facts_as_json(const Facts& facts, const Messages& messages) {
  const Json atoms = facts.has_atoms() ? json_of_atoms(facts) + json_of_survey(facts) : Json{};
  print_json(json_of_file(facts) + atoms + json_of_bars(facts) + json_of_limits(facts) +
             Json{{"warnings", messages.warnings()}, {"notes", messages.notes()}});
}

std::string listed(const Counts& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    if (count != 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text.empty() ? "none" : text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
  return text;
}

std::string numbered(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void print_row(std::string_view label, std::size_t value, std::string_view comment) {
  fmt::print("{:<12}{:>10}{}{}\n", label, value, comment.empty() ? "" : "   ", comment);
}

/// Warnings tell of other guesses; they are on stderr by now.
void print_guesses(const Facts& facts, const Messages& messages) {
  const auto origin = static_cast<std::size_t>(BondOrigin::distance);
  const std::size_t by_distance = facts.has_atoms() ? facts.bonds_by_origin[origin].second : 0;
  if (by_distance != 0)
    fmt::print("guessed: {} bonds, from distances and covalent radii\n", by_distance);
  else if (messages.warnings().empty())
    fmt::print("nothing was guessed\n");
}

std::string pinned_joints(const Facts& facts) {
  return facts.pinned == 0 ? "" : numbered(facts.pinned, "joint pinned", "joints pinned");
}

void print_molecule_rows(const Facts& facts) {
  const Structure& structure = facts.structure;
  fmt::print("{} ({}, model {} of {})\n", printable_name(facts.options.input.file),
             structure.format, structure.model, structure.model_count);
  print_row("atoms", structure.size(), listed(facts.elements));
  if (!structure.assemblies.empty())
    print_row(
        "assemblies", structure.assemblies.size(),
        fmt::format("{}: biological ones, which --assembly makes", joined(structure.assemblies)));
  print_row("residues", structure.atoms.residues.size(), numbered(facts.chains, "chain", "chains"));
  print_row("bonds", structure.bonds.size(), "from " + listed(facts.bonds_by_origin));
  const std::string pinned = pinned_joints(facts);
  const std::string planar =
      facts.planar_bars == 0 ? ""
                             : fmt::format(", {} of them hold planar groups", facts.planar_bars);
  print_row("bars", facts.graph.bars,
            bars_of(facts.options) + planar + (pinned.empty() ? "" : ", " + pinned));
}

void print_graph_rows(const Facts& facts) {
  fmt::print("{} (graph)\n", printable_name(facts.options.input.file));
  print_row("joints", facts.graph.joints, pinned_joints(facts));
  print_row("bars", facts.graph.bars, "");
}

/// Prints only what is there: most frameworks have bars alone.
void print_limit_rows(const Facts& facts) {
  if (const std::size_t limits = sum_of(facts.limits_by_kind); limits != 0)
    print_row("limits", limits, "of kind " + listed(facts.limits_by_kind));
  if (facts.has_sterics) fmt::print("sterics: joints keep least distances\n");
}

void print_table(const Facts& facts) {
  const GraphFacts& graph = facts.graph;
  facts.has_atoms() ? print_molecule_rows(facts) : print_graph_rows(facts);
  print_row("components", graph.components, "");
  print_row(
      "cycles", graph.cycles,
      fmt::format("independent: bars - {} + components", facts.has_atoms() ? "atoms" : "joints"));
  print_row("bridges", graph.bridges, "bars on no cycle");
  print_row("blocks", graph.blocks,
            fmt::format("ring systems, with {} bars in all, {} in the largest",
                        graph.bars_in_blocks, graph.largest_block));
  print_limit_rows(facts);
}

/// A molecule without residues has nothing to add to its atoms and bonds.
void print_survey(const Facts& facts) {
  const Survey& found = facts.survey;
  if (!facts.has_atoms() || found.amino_acids + found.nucleotides + found.waters == 0) return;
  for (const std::string& line : found_lines(facts.structure, facts.survey))
    fmt::print("found       {}\n", line);
  for (const std::string& line : missing_lines(facts.structure, facts.survey))
    fmt::print("missing     {}\n", line);
}

}  // namespace

int command_info(const Arguments& arguments) {
  CommandLine line(
      "pliant info",
      "Lists what is in a molecule file: atoms, bonds and how they are known, what was\n"
      "guessed, and what is missing for the model of a protein. Then what the bars (pairs of\n"
      "atoms at a fixed distance) form: components (connected parts), cycles, bridges (bars\n"
      "on no cycle) and blocks (ring systems).");
  line.set_footer(
      "Examples:\n"
      "  pliant info protein.pdb\n"
      "  pliant info complex.cif --assembly 1 --select \"protein\"\n"
      "  pliant info drug.sdf --json");
  MoleculeOptions options;
  options.may_be_cut = true;
  bool as_json = false;
  add_molecule_options(line, options);
  line.start_group("Output");
  line.add_flag("--json", as_json, "print one JSON object");
  line.set_common({"--assembly", "--select", "--model", "--bars", "--json"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  Messages messages(as_json);
  const Molecule molecule = load_molecule(options, messages.log());
  const Facts facts = facts_of(options, molecule);
  if (as_json) {
    print_facts_as_json(facts, messages);
  } else {
    print_table(facts);
    print_survey(facts);
    print_guesses(facts, messages);
  }
  return exit_ok;
}

}  // namespace pliant::app
