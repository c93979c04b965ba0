// SPDX-License-Identifier: MIT
// What holds metals: N, O, S, Se, halogens and C in reach of one (coordination_reach), but for the
// complex, as haem is one, that the metal is bonded in.
#include <algorithm>

#include "pliant/base/elements.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/molecule/bonds/coordination.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t sulphur = 16;
constexpr double metal_energy = -20.0;  // kcal/mol: never diluted

/// Whether a metal holds an atom: one in reach that is not of the complex the metal is bonded in.
bool holds(const Structure& structure, const AtomGraph& graph, std::uint32_t metal,
           std::uint32_t atom) {
  const AtomTable& atoms = structure.atoms;
  if (distance(structure.positions[metal], structure.positions[atom]) >
      coordination_reach(atoms.elements[metal], atoms.elements[atom]))
    return false;
  const bool is_in_complex = !graph.at(metal).empty();
  return !(is_in_complex && atoms.residue_of[metal] == atoms.residue_of[atom]) &&
         !graph.are_within_two_bonds(metal, atom);
}

}  // namespace

std::vector<MolecularContact> find_metals(const Structure& structure, const ContactOptions&) {
  const AtomGraph graph(structure);
  std::vector<std::uint32_t> metals, others;
  for (std::uint32_t i = 0; i < structure.size(); ++i)
    (is_metal(structure.atoms.elements[i]) ? metals : others).push_back(i);
  if (metals.empty()) return {};
  double furthest = 0.0;
  for (std::uint32_t metal : metals)
    furthest = std::max(furthest, coordination_reach(structure.atoms.elements[metal], sulphur));
  const auto near = near_atoms(structure, metals, others, furthest);
  std::vector<MolecularContact> found;
  for (std::size_t k = 0; k < metals.size(); ++k)
    for (std::uint32_t atom : near.at(k)) {
      if (!holds(structure, graph, metals[k], atom)) continue;
      MolecularContact contact{MolecularContactKind::metal, metals[k], atom};
      contact.energy = metal_energy;
      set_limits(contact, structure);
      found.push_back(contact);
    }
  sort(found);
  return found;
}

}  // namespace pliant
