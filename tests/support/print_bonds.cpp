// SPDX-License-Identifier: MIT
// What the library makes of molecule files, as one line of JSON for each line on standard input:
//
//   pliant_print_bonds bonds        a file name -> its atoms, bonds by origin, and messages
//   pliant_print_bonds facts        a file name -> atoms, bars of both kinds, independent cycles
//   pliant_print_bonds select FILE  a selection -> indices of the atoms
//   pliant_print_bonds templates    a residue name -> the names of bonded atoms; "*": all names
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace {

using Json = nlohmann::ordered_json;
using namespace pliant;

Structure read(const std::string& file, Json& messages) {
  const Log log{[&](Severity, std::string_view text) { messages.push_back(text); }};
  Structure structure = read_structure(std::filesystem::path(file), {.log = log});
  perceive_bonds(structure, {.log = log});
  return structure;
}

Json bonds_of(const std::string& file) {
  Json messages = Json::array(), labels = Json::array(), bonds = Json::array();
  const Structure structure = read(file, messages);
  for (std::size_t i = 0; i < structure.size(); ++i) labels.push_back(structure.atoms.label(i));
  for (const Bond& bond : structure.bonds)
    bonds.push_back({bond.a, bond.b, bond_origin_names[static_cast<std::size_t>(bond.origin)]});
  return {{"labels", labels}, {"bonds", bonds}, {"messages", messages}};
}

Json facts_of(const std::string& file) {
  Json messages = Json::array();
  const Structure structure = read(file, messages);
  const Framework bonds = build_framework(structure);
  const Framework angles = build_framework(structure, {.bars = BarKind::angles});
  return {{"atoms", structure.size()},
          {"bonds", bonds.bar_count()},
          {"angles", angles.bar_count()},
          {"cycles", graph_facts(bonds).cycles},
          {"components", graph_facts(bonds).components},
          {"messages", messages}};
}

std::string text_of(AtomKey key) {
  std::string text;
  for (; key != 0; key >>= 8) text += static_cast<char>(key & 0xff);
  std::reverse(text.begin(), text.end());
  return text;
}

Json template_of(const std::string& name) {
  if (name == "*") return {{"names", residue_template_names()}};
  const ResidueTemplate* shape = find_residue_template(name);
  if (shape == nullptr) return {{"bonds", nullptr}};
  Json bonds = Json::array();
  for (const ResidueTemplate::Edge& edge : shape->edges)
    bonds.push_back({text_of(shape->names[edge.a]), text_of(shape->names[edge.b])});
  return {{"bonds", bonds}};
}

template <class Answer>
void answer_lines(const Answer& answer) {
  for (std::string line; std::getline(std::cin, line);) {
    Json result;
    try {
      result = answer(line);
    } catch (const Error& error) {
      result = {{"error", error.what()}};
    }
    std::cout << result.dump() << '\n';
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string mode = count > 1 ? words[1] : "";
  if (mode == "bonds") {
    answer_lines(bonds_of);
  } else if (mode == "facts") {
    answer_lines(facts_of);
  } else if (mode == "templates") {
    answer_lines(template_of);
  } else if (mode == "select" && count == 3) {
    const Structure structure = read_structure(std::filesystem::path(words[2]));
    answer_lines([&](const std::string& text) -> Json {
      return {{"atoms", select_atoms(structure.atoms, text)}};
    });
  } else {
    std::cerr << "usage: pliant_print_bonds bonds|facts|templates|select FILE\n";
    return 2;
  }
}
