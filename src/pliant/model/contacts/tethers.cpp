// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/tethers.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/elements.hpp"
#include "pliant/base/math/cell_list.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/molecule/bonds/coordination.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, sulphur = 16;
constexpr double carbon_radius = 1.7, sulphur_radius = 1.8;  // Angstrom, van der Waals (Bondi)
constexpr double tether_energy = -1.0;                       // kcal/mol
constexpr double metal_energy = -20.0;                       // kcal/mol: never diluted

bool is_carbon_or_sulphur(const Structure& structure, std::uint32_t atom) {
  const std::uint8_t element = structure.atoms.elements[atom];
  return element == carbon || element == sulphur;
}

double radius(const Structure& structure, std::uint32_t atom) {
  return structure.atoms.elements[atom] == sulphur ? sulphur_radius : carbon_radius;
}

/// C and S whose neighbours are C, S and H only.
std::vector<std::uint32_t> hydrophobic_atoms(const Structure& structure) {
  const AtomGraph graph(structure);
  std::vector<std::uint32_t> atoms;
  for (std::uint32_t i = 0; i < structure.size(); ++i) {
    const auto links = graph.at(i);
    if (is_carbon_or_sulphur(structure, i) &&
        std::all_of(links.begin(), links.end(), [&](const Link& link) {
          return graph.is_hydrogen(link.node) || is_carbon_or_sulphur(structure, link.node);
        }))
      atoms.push_back(i);
  }
  return atoms;
}

/// Whether two atoms belong to one residue or to neighbours in a chain.
bool are_of_neighbours(const AtomTable& atoms, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t p = std::min(atoms.residue_of[a], atoms.residue_of[b]);
  const std::uint32_t q = std::max(atoms.residue_of[a], atoms.residue_of[b]);
  return q == p || (q == p + 1 && atoms.residues[p].chain == atoms.residues[q].chain);
}

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

std::vector<MolecularContact> hydrophobic_tethers(const Structure& structure,
                                                  const TetherOptions& options) {
  const std::vector<std::uint32_t> atoms = hydrophobic_atoms(structure);
  std::vector<Vec3> points;
  for (std::uint32_t atom : atoms) points.push_back(structure.positions[atom]);
  std::vector<MolecularContact> found;
  const double furthest = 2.0 * sulphur_radius + options.reach;
  CellList(points, furthest).for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
    const std::uint32_t a = atoms[i], b = atoms[j];
    const double usual = radius(structure, a) + radius(structure, b);
    if (std::sqrt(squared) >= usual + options.reach) return;
    if (are_of_neighbours(structure.atoms, a, b)) return;
    MolecularContact contact{MolecularContactKind::hydrophobic, a, b};
    contact.energy = tether_energy;
    set_limits(contact, structure, usual);
    found.push_back(contact);
  });
  sort(found);
  return found;
}

std::vector<MolecularContact> find_tethers(const Structure& structure,
                                           const ContactOptions& options) {
  return hydrophobic_tethers(structure, options.tethers);
}

std::vector<MolecularContact> metal_contacts(const Structure& structure) {
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

std::vector<MolecularContact> find_metals(const Structure& structure, const ContactOptions&) {
  return metal_contacts(structure);
}

}  // namespace pliant
