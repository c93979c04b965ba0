// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/polar_atoms.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, nitrogen = 7, oxygen = 8, phosphorus = 15, sulphur = 16;

/// (R)
std::vector<bool> residues_with_hydrogens(const Structure& structure, const AtomGraph& graph) {
  std::vector<bool> found(structure.atoms.residues.size(), false);
  for (std::uint32_t i = 0; i < structure.size(); ++i)
    if (graph.is_hydrogen(i)) found[structure.atoms.residue_of[i]] = true;
  return found;
}

}  // namespace

PolarAtoms::PolarAtoms(const Structure& structure, const AtomGraph& graph)
    : structure_(structure),
      graph_(graph),
      has_hydrogens_(residues_with_hydrogens(structure, graph)),
      bare_(structure, graph, has_hydrogens_) {
  for (std::uint32_t i = 0; i < structure.size(); ++i) {
    if (!graph.is_hydrogen(i)) continue;
    const std::uint32_t parent = graph.first_heavy(i);
    if (parent == no_atom) continue;
    const std::uint8_t element = structure.atoms.elements[parent];
    if (element == nitrogen || element == oxygen) hydrogens_.push_back(i);
  }
  for (std::uint32_t i = 0; i < structure.size(); ++i)
    if (is_acceptor(i)) acceptors_.push_back(i);
}

/// Of N in proteins only ring N of two neighbours is one. In residues without any hydrogen it could
/// be a donor as well, which is settled by what it is near to.
bool PolarAtoms::is_acceptor(std::uint32_t atom) const {
  const std::uint8_t element = structure_.atoms.elements[atom];
  if (element == oxygen) return true;
  if (element != nitrogen || graph_.at(atom).size() != 2 || graph_.hydrogens_at(atom) > 0)
    return false;
  const std::uint32_t r = structure_.atoms.residue_of[atom];
  const Residue& residue = structure_.atoms.residues[r];
  if (is_amino_acid(residue)) return is_in(atom, "HIS") && structure_.atoms.names[atom] != "N";
  return is_nucleotide(residue) || has_hydrogens_[r] ||
         (bare_.contains(atom) && !is_amide_nitrogen(structure_, graph_, atom));
}

bool PolarAtoms::is_in(std::uint32_t atom, std::string_view residue) const {
  return standard_name(structure_.atoms.residues[structure_.atoms.residue_of[atom]].name) ==
         residue;
}

bool PolarAtoms::is_bonded_to(std::uint32_t atom, std::uint8_t element) const {
  const auto links = graph_.at(atom);
  return std::any_of(links.begin(), links.end(), [&](const Link& link) {
    return structure_.atoms.elements[link.node] == element;
  });
}

Hybridisation PolarAtoms::hybridisation(std::uint32_t atom) const {
  using enum Hybridisation;
  const std::size_t count = graph_.at(atom).size();
  if (structure_.atoms.elements[atom] == nitrogen)
    return count >= 4 || (count == 3 && !is_planar(structure_, graph_, atom)) ? sp3 : sp2;
  if (is_bonded_to(atom, phosphorus) || is_bonded_to(atom, sulphur)) return sp3;
  if (count <= 1) return bare_.contains(atom) ? sp3 : sp2;
  const std::uint32_t neighbour = graph_.first_heavy(atom);
  const bool is_conjugated = graph_.hydrogens_at(atom) == 1 && neighbour != no_atom &&
                             structure_.atoms.elements[neighbour] == carbon &&
                             graph_.at(neighbour).size() == 3 &&
                             is_planar(structure_, graph_, neighbour);
  return is_conjugated ? sp2 : sp3;
}

bool PolarAtoms::is_positive(std::uint32_t donor) const {
  if (!structure_.charges.empty() && structure_.charges[donor] > 0) return true;
  if (structure_.atoms.elements[donor] != nitrogen) return false;
  if (graph_.at(donor).size() >= 4) return true;
  const std::string& name = structure_.atoms.names[donor];
  if (is_in(donor, "ARG")) return name == "NE" || name == "NH1" || name == "NH2";
  return is_in(donor, "HIS") && (name == "ND1" || name == "NE2") && other_nitrogen_donates(donor);
}

/// Whether N on the far side of a C between two N has a hydrogen, as in charged His.
bool PolarAtoms::other_nitrogen_donates(std::uint32_t donor) const {
  for (const Link& link : graph_.at(donor))
    for (const Link& next : graph_.at(link.node))
      if (next.node != donor && structure_.atoms.elements[next.node] == nitrogen &&
          graph_.hydrogens_at(next.node) > 0)
        return true;
  return false;
}

/// O of a carboxylate or phosphate: alone on its C or P beside another such O, without hydrogens.
bool PolarAtoms::is_negative(std::uint32_t acceptor) const {
  if (!structure_.charges.empty() && structure_.charges[acceptor] < 0) return true;
  if (structure_.atoms.elements[acceptor] != oxygen || graph_.at(acceptor).size() != 1)
    return false;
  const std::uint32_t centre = graph_.at(acceptor)[0].node;
  const std::uint8_t element = structure_.atoms.elements[centre];
  if (element != carbon && element != phosphorus) return false;
  const auto links = graph_.at(centre);
  return std::count_if(links.begin(), links.end(), [&](const Link& link) {
           return structure_.atoms.elements[link.node] == oxygen &&
                  graph_.at(link.node).size() == 1;
         }) >= 2;
}

/// Files differ in where hydrogens stand: the plane is that of heavy atoms, where these span one.
std::vector<std::uint32_t> PolarAtoms::heavy_first(std::uint32_t atom, std::uint32_t left) const {
  std::vector<std::uint32_t> around;
  for (const Link& link : graph_.at(atom))
    if (link.node != left) around.push_back(link.node);
  std::ranges::stable_partition(around, [&](std::uint32_t i) { return !graph_.is_hydrogen(i); });
  return around;
}

Vec3 PolarAtoms::plane(std::uint32_t atom) const {
  const auto at = [&](std::uint32_t i) { return structure_.positions[i]; };
  const auto normal = [&](std::uint32_t centre, std::uint32_t one, std::uint32_t other) {
    return unit_vector(cross(at(one) - at(centre), at(other) - at(centre)));
  };
  const std::vector<std::uint32_t> around = heavy_first(atom, no_atom);
  if (around.size() >= 2) return normal(atom, around[0], around[1]);
  if (around.empty()) return {0.0, 0.0, 1.0};
  const std::uint32_t neighbour = around[0];
  const std::vector<std::uint32_t> others = heavy_first(neighbour, atom);
  if (others.empty()) return {0.0, 0.0, 1.0};
  return normal(neighbour, others[0], others.size() > 1 ? others[1] : atom);
}

}  // namespace pliant
