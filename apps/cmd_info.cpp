// SPDX-License-Identifier: MIT
// pliant info: what a file holds, and what was guessed.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "command.hpp"
#include "messages.hpp"
#include "molecule_input.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/framework/graph.hpp"

namespace pliant::app {
namespace {

using Json = nlohmann::ordered_json;

Json elements_of(const Structure& structure) {
  std::map<std::uint8_t, std::size_t> counts;
  for (std::uint8_t element : structure.atoms.elements) ++counts[element];
  Json json = Json::object();
  for (const auto& [element, count] : counts) json[std::string(element_symbol(element))] = count;
  return json;
}

Json bonds_by_origin(const Structure& structure) {
  std::array<std::size_t, bond_origin_names.size()> counts{};
  for (const Bond& bond : structure.bonds) ++counts[static_cast<std::size_t>(bond.origin)];
  Json json = Json::object();
  for (std::size_t k = 0; k < counts.size(); ++k)
    json[std::string(bond_origin_names[k])] = counts[k];
  return json;
}

std::size_t chains_of(const Structure& structure) {
  std::set<std::string_view> chains;
  for (const Residue& residue : structure.atoms.residues) chains.insert(residue.chain);
  return chains.size();
}

/// A graph XML file has joints and bars, and nothing of chemistry.
bool is_graph(const Structure& structure) { return structure.format == "graph"; }

Json atoms_and_bonds_of(const MoleculeOptions& options, const Structure& structure) {
  if (is_graph(structure)) return Json::object();
  return {{"atoms", structure.size()},       {"residues", structure.atoms.residues.size()},
          {"chains", chains_of(structure)},  {"elements", elements_of(structure)},
          {"bonds", structure.bonds.size()}, {"bonds_by_origin", bonds_by_origin(structure)},
          {"bar_kind", options.bars}};
}

Json bars_of(const Framework& framework) {
  const GraphFacts facts = graph_facts(framework);
  return {{"joints", framework.joint_count()},
          {"bars", facts.bars},
          {"pinned", framework.pinned_count()},
          {"components", facts.components},
          {"cycles", facts.cycles},
          {"bridges", facts.bridges},
          {"blocks", facts.blocks},
          {"largest_block", facts.largest_block},
          {"bars_in_blocks", facts.bars_in_blocks}};
}

Json facts_of(const MoleculeOptions& options, const Molecule& molecule, const Messages& messages) {
  const Structure& structure = molecule.structure;
  Json facts{{"file", options.file},
             {"format", structure.format},
             {"title", structure.title},
             {"model", structure.model},
             {"models", structure.model_count}};
  facts.update(atoms_and_bonds_of(options, structure));
  facts.update(bars_of(molecule.framework));
  facts.update({{"warnings", messages.warnings()}, {"notes", messages.notes()}});
  return facts;
}

std::string listed(const Json& counts) {
  std::string text;
  for (const auto& [key, count] : counts.items())
    if (count != 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, count.dump());
  return text.empty() ? "none" : text;
}

void print_row(std::string_view label, const Json& value, std::string_view comment) {
  fmt::print("{:<12}{:>10}{}{}\n", label, value.dump(), comment.empty() ? "" : "   ", comment);
}

/// Warnings tell of other guesses; they are on stderr by now.
void print_guesses(const Json& facts) {
  const Json by_distance = facts.value("/bonds_by_origin/distance"_json_pointer, Json(0));
  if (by_distance != 0)
    fmt::print("guessed: {} bonds, from distances and covalent radii\n", by_distance.dump());
  else if (facts["warnings"].empty())
    fmt::print("nothing was guessed\n");
}

std::string pinned_joints(const Json& facts) {
  if (facts["pinned"] == 0) return "";
  return facts["pinned"].dump() + (facts["pinned"] == 1 ? " joint pinned" : " joints pinned");
}

void print_molecule_rows(const Json& facts) {
  fmt::print("{} ({}, model {} of {})\n", facts["file"].get<std::string>(),
             facts["format"].get<std::string>(), facts["model"].dump(), facts["models"].dump());
  print_row("atoms", facts["atoms"], listed(facts["elements"]));
  print_row("residues", facts["residues"],
            facts["chains"].dump() + (facts["chains"] == 1 ? " chain" : " chains"));
  print_row("bonds", facts["bonds"], "from " + listed(facts["bonds_by_origin"]));
  const std::string pinned = pinned_joints(facts);
  print_row("bars", facts["bars"],
            facts["bar_kind"].get<std::string>() + (pinned.empty() ? "" : ", " + pinned));
}

void print_graph_rows(const Json& facts) {
  fmt::print("{} (graph)\n", facts["file"].get<std::string>());
  print_row("joints", facts["joints"], pinned_joints(facts));
  print_row("bars", facts["bars"], "");
}

void print_table(const Json& facts) {
  const bool has_atoms = facts.contains("atoms");
  has_atoms ? print_molecule_rows(facts) : print_graph_rows(facts);
  print_row("components", facts["components"], "");
  print_row("cycles", facts["cycles"],
            fmt::format("independent: bars - {} + components", has_atoms ? "atoms" : "joints"));
  print_row("bridges", facts["bridges"], "bars on no cycle");
  print_row("blocks", facts["blocks"],
            fmt::format("ring systems, with {} bars in all, {} in the largest",
                        facts["bars_in_blocks"].dump(), facts["largest_block"].dump()));
  print_guesses(facts);
}

}  // namespace

int command_info(const Arguments& arguments) {
  CLI::App app{
      "Tells what a molecule file holds: atoms, bonds and where each comes from, bars,\n"
      "components, independent cycles, bridges and blocks. Says what was guessed.",
      "pliant info"};
  prepare(app);
  MoleculeOptions options;
  bool as_json = false;
  add_molecule_options(app, options);
  start_group(app, "Output");
  app.add_flag("--json", as_json, "print one JSON object");
  if (const int code = parse(app, arguments); code >= 0) return code;
  Messages messages(as_json);
  const Molecule molecule = load(options, messages.log());
  const Json facts = facts_of(options, molecule, messages);
  if (as_json) {
    fmt::print("{}\n", facts.dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    print_table(facts);
  }
  return exit_ok;
}

}  // namespace pliant::app
