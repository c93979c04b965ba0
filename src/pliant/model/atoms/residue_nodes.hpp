// SPDX-License-Identifier: MIT
// Atoms that represent residues in an elastic network.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

inline constexpr std::uint32_t no_residue_node = ~std::uint32_t{0};

/// The nodes of a structure, as plain arrays.
struct ResidueNodes {
  std::vector<Vec3> positions;         ///< (M) Angstrom, of the atom of each node
  std::vector<std::uint32_t> chain;    ///< (M) nodes of a chain are consecutive
  std::vector<std::uint32_t> of_atom;  ///< (N) node with which each atom moves
  std::vector<std::uint32_t> atom;     ///< (M) atom of each node
  std::vector<bool> is_residue;        ///< (M) whether the node represents a residue of a polymer
};

/// Makes a node at the alpha carbon of an amino acid, at P (or C4') of a nucleotide, if these are
/// parts of a polymer (polymer_residues), and at each heavy atom of anything else, whose hydrogens
/// move with the heavy atoms they are bonded to. Atoms of a residue without any of these, such as a
/// lone hydrogen, have no node.
ResidueNodes residue_nodes(const Structure& structure);

}  // namespace pliant
