// SPDX-License-Identifier: MIT
// Small structures written out in a test, and bonds as text.
#pragma once

#include <string>
#include <vector>

#include "pliant/base/elements.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::test {

struct MadeAtom {
  const char* name;
  const char* element;
  Vec3 position;
};

/// Adds one residue with these atoms.
inline void add_residue(Structure& s, const std::string& name, std::int64_t number,
                        const std::vector<MadeAtom>& atoms, const std::string& chain = "A") {
  const auto residue = static_cast<std::uint32_t>(s.atoms.residues.size());
  s.atoms.residues.push_back({name, number, ' ', chain});
  for (const MadeAtom& atom : atoms) {
    s.atoms.names.emplace_back(atom.name);
    s.atoms.elements.push_back(element_number(atom.element));
    s.atoms.residue_of.push_back(residue);
    s.atoms.serials.push_back(static_cast<std::int64_t>(s.atoms.names.size()));
    s.positions.push_back(atom.position);
  }
}

/// A molecule without residues: names are elements.
inline Structure molecule(const std::vector<std::pair<const char*, Vec3>>& atoms) {
  Structure s;
  std::vector<MadeAtom> made;
  for (const auto& [element, position] : atoms) made.push_back({element, element, position});
  add_residue(s, "UNK", 1, made, "");
  return s;
}

/// The heavy atoms of glycine, N first.
inline std::vector<MadeAtom> glycine(Vec3 at) {
  return {{"N", "N", at},
          {"CA", "C", at + Vec3{1.46, 0, 0}},
          {"C", "C", at + Vec3{2.0, 1.42, 0}},
          {"O", "O", at + Vec3{1.3, 2.42, 0}}};
}

/// A water molecule, oxygen first.
inline std::vector<MadeAtom> water(Vec3 at) {
  return {{"OW", "O", at},
          {"HW1", "H", at + Vec3{0.96, 0, 0}},
          {"HW2", "H", at + Vec3{-0.24, 0.93, 0}}};
}

/// "0-1 1-2 residue, 1-3 link": bonds in their order, with origins.
inline std::string bonds_text(const Structure& s) {
  std::string text;
  std::string_view before;
  for (const Bond& bond : s.bonds) {
    const std::string_view origin = bond_origin_names[static_cast<std::size_t>(bond.origin)];
    if (!text.empty()) text += origin == before ? " " : " " + std::string(before) + ", ";
    text += std::to_string(bond.a) + "-" + std::to_string(bond.b);
    before = origin;
  }
  return text.empty() ? "" : text + " " + std::string(before);
}

/// What perceive_bonds finds, and what it says on the way.
struct Perceived {
  std::string bonds;
  std::size_t count = 0;  ///< of bonds
  std::vector<std::string> messages;
};

inline Perceived perceive(Structure s, BondOptions options = {}) {
  Perceived result;
  options.log.function = [&](Severity severity, std::string_view text) {
    result.messages.push_back((severity == Severity::warning ? "warning: " : "note: ") +
                              std::string(text));
  };
  perceive_bonds(s, options);
  result.bonds = bonds_text(s);
  result.count = s.bonds.size();
  return result;
}

}  // namespace pliant::test
