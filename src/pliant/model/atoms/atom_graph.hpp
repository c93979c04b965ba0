// SPDX-License-Identifier: MIT
// The bonds of a structure as a graph, with the queries that chemistry needs.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

inline constexpr std::uint32_t no_atom = ~std::uint32_t{0};

/// Neighbours of each atom over bonds. The structure must outlive it.
class AtomGraph {
 public:
  explicit AtomGraph(const Structure& structure);

  std::span<const Link> at(std::uint32_t atom) const { return graph_.at(atom); }
  bool is_hydrogen(std::uint32_t atom) const { return structure_.atoms.elements[atom] == 1; }
  std::size_t hydrogens_at(std::uint32_t atom) const;
  /// Bonded atoms other than hydrogen, in the order of the bonds.
  std::vector<std::uint32_t> heavy_at(std::uint32_t atom) const;
  /// The first of these that is not `except`; no_atom if there is none.
  std::uint32_t first_heavy(std::uint32_t atom, std::uint32_t except = no_atom) const;
  bool are_bonded(std::uint32_t a, std::uint32_t b) const;
  /// Whether two atoms are bonded to each other or to a common atom.
  bool are_within_two_bonds(std::uint32_t a, std::uint32_t b) const;

 private:
  const Structure& structure_;
  Graph graph_;
};

/// The atoms of each residue, which are consecutive, found by name.
class ResidueAtoms {
 public:
  explicit ResidueAtoms(const AtomTable& atoms);
  std::uint32_t begin(std::size_t residue) const { return first_[residue]; }
  std::uint32_t end(std::size_t residue) const { return first_[residue + 1]; }
  /// The atom called `name`; no_atom if there is none.
  std::uint32_t find(std::size_t residue, std::string_view name) const;

 private:
  const AtomTable& atoms_;
  std::vector<std::uint32_t> first_;  ///< (R + 1)
};

}  // namespace pliant
