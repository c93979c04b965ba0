// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/residue_nodes.hpp"

#include <string_view>
#include <utility>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t hydrogen = 1, carbon = 6, phosphorus = 15;

class NodeFinder {
 public:
  explicit NodeFinder(const Structure& structure)
      : structure_(structure),
        residues_(structure.atoms),
        graph_(structure),
        is_polymer_(polymer_residues(structure)) {
    nodes_.of_atom.assign(structure.size(), no_residue_node);
  }

  ResidueNodes run() {
    for (std::size_t k = 0; k < structure_.atoms.residues.size(); ++k) {
      if (k > 0 && ends_chain(k - 1)) ++chain_;
      const std::uint32_t atom = atom_of_polymer(k);
      if (atom != no_atom) {
        add(atom, true);
        for (std::uint32_t i = residues_.begin(k); i < residues_.end(k); ++i)
          nodes_.of_atom[i] = static_cast<std::uint32_t>(nodes_.positions.size() - 1);
      } else {
        add_each_atom(k);
      }
    }
    return std::move(nodes_);
  }

 private:
  void add(std::uint32_t atom, bool is_residue) {
    nodes_.positions.push_back(structure_.positions[atom]);
    nodes_.chain.push_back(chain_);
    nodes_.atom.push_back(atom);
    nodes_.is_residue.push_back(is_residue);
  }

  bool ends_chain(std::size_t residue) const {
    const auto& residues = structure_.atoms.residues;
    const bool is_last = !structure_.chain_end.empty() && structure_.chain_end[residue];
    return is_last || residues[residue].chain != residues[residue + 1].chain;
  }

  std::uint32_t find(std::size_t residue, std::string_view name, std::uint8_t element) const {
    const std::uint32_t atom = residues_.find(residue, name);
    const bool fits = atom != no_atom && structure_.atoms.elements[atom] == element;
    return fits ? atom : no_atom;
  }

  std::uint32_t atom_of_polymer(std::size_t residue) const {
    if (!is_polymer_[residue]) return no_atom;
    const std::uint32_t alpha = find(residue, "CA", carbon);
    if (alpha != no_atom && residues_.find(residue, "N") != no_atom) return alpha;
    const std::uint32_t sugar = find(residue, "C4'", carbon);
    if (sugar == no_atom) return no_atom;
    const std::uint32_t phosphate = find(residue, "P", phosphorus);
    return phosphate != no_atom ? phosphate : sugar;
  }

  /// Atoms of a ligand are no chain: each is one of its own.
  void add_each_atom(std::size_t residue) {
    for (std::uint32_t i = residues_.begin(residue); i < residues_.end(residue); ++i) {
      if (structure_.atoms.elements[i] == hydrogen) continue;
      ++chain_;
      add(i, false);
      nodes_.of_atom[i] = static_cast<std::uint32_t>(nodes_.positions.size() - 1);
    }
    ++chain_;
    for (std::uint32_t i = residues_.begin(residue); i < residues_.end(residue); ++i) {
      if (structure_.atoms.elements[i] != hydrogen) continue;
      const std::uint32_t heavy = graph_.first_heavy(i);
      if (heavy != no_atom) nodes_.of_atom[i] = nodes_.of_atom[heavy];
    }
  }

  const Structure& structure_;
  ResidueAtoms residues_;
  AtomGraph graph_;
  std::vector<bool> is_polymer_;
  ResidueNodes nodes_;
  std::uint32_t chain_ = 0;
};

}  // namespace

ResidueNodes residue_nodes(const Structure& structure) { return NodeFinder(structure).run(); }

}  // namespace pliant
