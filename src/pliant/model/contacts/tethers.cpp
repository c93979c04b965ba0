// SPDX-License-Identifier: MIT
// Hydrophobic tethers: C and S whose neighbours are C, S and H only, in residues that are two or
// more apart, nearer than the sum of their van der Waals radii (C 1.7, S 1.8 Angstrom) + 0.5. Held
// below max(start, sum) + 0.5 Angstrom, as FIRST and FRODA do (Hespenheide et al., J. Phys.
// Condens. Matter 16 (2004) S5055; they take 0.25).
#include <algorithm>
#include <cmath>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/contacts/contact_list.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, sulphur = 16;
constexpr double carbon_radius = 1.7, sulphur_radius = 1.8;  // Angstrom, van der Waals (Bondi)
constexpr double tether_energy = -1.0;                       // kcal/mol

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

}  // namespace

std::vector<MolecularContact> find_tethers(const Structure& structure,
                                           const ContactOptions& options) {
  const std::vector<std::uint32_t> atoms = hydrophobic_atoms(structure);
  std::vector<Vec3> points;
  for (std::uint32_t atom : atoms) points.push_back(structure.positions[atom]);
  std::vector<MolecularContact> found;
  const double furthest = 2.0 * sulphur_radius + options.tethers.reach;
  CellList(points, furthest).for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
    const std::uint32_t a = atoms[i], b = atoms[j];
    const double usual = radius(structure, a) + radius(structure, b);
    if (std::sqrt(squared) >= usual + options.tethers.reach) return;
    if (are_of_neighbours(structure.atoms, a, b)) return;
    MolecularContact contact{MolecularContactKind::hydrophobic, a, b};
    contact.energy = tether_energy;
    set_limits(contact, structure, usual);
    found.push_back(contact);
  });
  sort(found);
  return found;
}

}  // namespace pliant
