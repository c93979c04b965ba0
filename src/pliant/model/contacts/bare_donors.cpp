// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/bare_donors.hpp"

#include <algorithm>

#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, nitrogen = 7, oxygen = 8, sulphur = 16;
// Angstrom. C=O has 1.23, carboxylates 1.25, phenols 1.36; a nitrile 1.15, C=N of amidines 1.31.
constexpr double longest_carbonyl = 1.29, longest_nitrile = 1.22;
constexpr double bond_length = 1.0;        // N-H, O-H
constexpr double widest_cosine = -0.7071;  // of 135 degrees, at N with hydrogens; azides are wider
constexpr double bent_cosine = -0.4226;    // of 115 degrees: two bonds of sp3

double cosine_at(Vec3 one, Vec3 at, Vec3 other) {
  return dot(unit_vector(one - at), unit_vector(other - at));
}

}  // namespace

BareDonors::BareDonors(const Structure& structure, const AtomGraph& graph,
                       const std::vector<bool>& has_hydrogens)
    : structure_(structure), graph_(graph), is_donor_(structure.size(), false) {
  for (std::uint32_t i = 0; i < structure.size(); ++i) {
    const std::uint32_t r = structure.atoms.residue_of[i];
    const Residue& residue = structure.atoms.residues[r];
    if (has_hydrogens[r] || is_amino_acid(residue) || is_nucleotide(residue)) continue;
    is_donor_[i] = may_donate(i);
    if (is_donor_[i]) atoms_.push_back(i);
  }
}

bool BareDonors::may_donate(std::uint32_t atom) const {
  const std::uint8_t element = structure_.atoms.elements[atom];
  const auto links = graph_.at(atom);
  if (links.empty() || has_other_neighbours(atom)) return false;
  const auto at = [&](std::uint32_t i) { return structure_.positions[i]; };
  const double first = distance(at(atom), at(links[0].node));
  if (element == oxygen)
    return links.size() == 1 && structure_.atoms.elements[links[0].node] == carbon &&
           first > longest_carbonyl;
  if (element != nitrogen) return false;
  if (links.size() == 1) return first > longest_nitrile;
  if (links.size() == 2)
    return cosine_at(at(links[0].node), at(atom), at(links[1].node)) > widest_cosine;
  return links.size() == 3 && !is_planar(structure_, graph_, atom);
}

/// As metals, P and O, at which nothing is guessed.
bool BareDonors::has_other_neighbours(std::uint32_t atom) const {
  return std::ranges::any_of(graph_.at(atom), [&](const Link& link) {
    const std::uint8_t element = structure_.atoms.elements[link.node];
    return element != carbon && element != nitrogen && element != sulphur;
  });
}

std::size_t BareDonors::hydrogens_of(std::uint32_t donor) const {
  const bool is_amine =
      structure_.atoms.elements[donor] == nitrogen && graph_.at(donor).size() == 1;
  return is_amine ? 2 : 1;
}

Vec3 BareDonors::hydrogen_towards(std::uint32_t donor, Vec3 acceptor) const {
  const auto links = graph_.at(donor);
  const auto at = [&](std::size_t k) { return structure_.positions[links[k].node]; };
  const Vec3 own = structure_.positions[donor];
  if (links.size() == 1) {
    const bool is_oxygen = structure_.atoms.elements[donor] == oxygen;
    return Spin(acceptor, at(0), own)
        .at(bond_length, is_oxygen ? tetrahedral_angle : planar_angle, 0);
  }
  if (links.size() == 3) return against_three(own, at(0), at(1), at(2), bond_length);
  if (cosine_at(at(0), own, at(1)) < bent_cosine)
    return against_both(own, at(0), at(1), bond_length);
  const Vec3 above = out_of_plane(own, at(0), at(1), bond_length, 1.0);
  const Vec3 below = out_of_plane(own, at(0), at(1), bond_length, -1.0);
  return distance(above, acceptor) < distance(below, acceptor) ? above : below;
}

bool is_amide_nitrogen(const Structure& structure, const AtomGraph& graph, std::uint32_t atom) {
  return std::ranges::any_of(graph.at(atom), [&](const Link& link) {
    if (structure.atoms.elements[link.node] != carbon) return false;
    return std::ranges::any_of(graph.at(link.node), [&](const Link& next) {
      return structure.atoms.elements[next.node] == oxygen && graph.at(next.node).size() == 1 &&
             distance(structure.positions[link.node], structure.positions[next.node]) <=
                 longest_carbonyl;
    });
  });
}

}  // namespace pliant
