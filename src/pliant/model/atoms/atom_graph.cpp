// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/atom_graph.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {

AtomGraph::AtomGraph(const Structure& structure)
    : structure_(structure), graph_(structure.size(), structure.bonds) {}

std::size_t AtomGraph::hydrogens_at(std::uint32_t atom) const {
  const auto links = at(atom);
  return static_cast<std::size_t>(std::count_if(
      links.begin(), links.end(), [&](const Link& link) { return is_hydrogen(link.node); }));
}

std::vector<std::uint32_t> AtomGraph::heavy_at(std::uint32_t atom) const {
  std::vector<std::uint32_t> heavy;
  for (const Link& link : at(atom))
    if (!is_hydrogen(link.node)) heavy.push_back(link.node);
  return heavy;
}

std::uint32_t AtomGraph::first_heavy(std::uint32_t atom, std::uint32_t except) const {
  for (const Link& link : at(atom))
    if (!is_hydrogen(link.node) && link.node != except) return link.node;
  return no_atom;
}

bool AtomGraph::are_bonded(std::uint32_t a, std::uint32_t b) const {
  const auto links = at(a);
  return std::any_of(links.begin(), links.end(), [&](const Link& link) { return link.node == b; });
}

bool AtomGraph::are_within_two_bonds(std::uint32_t a, std::uint32_t b) const {
  if (are_bonded(a, b)) return true;
  const auto links = at(a);
  return std::any_of(links.begin(), links.end(),
                     [&](const Link& link) { return are_bonded(link.node, b); });
}

ResidueAtoms::ResidueAtoms(const AtomTable& atoms)
    : atoms_(atoms), first_(atoms.residues.size() + 1, 0) {
  for (std::uint32_t residue : atoms.residue_of) ++first_[residue + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::uint32_t ResidueAtoms::find(std::size_t residue, std::string_view name) const {
  for (std::uint32_t atom = begin(residue); atom < end(residue); ++atom)
    if (atoms_.names[atom] == name) return atom;
  return no_atom;
}

}  // namespace pliant
