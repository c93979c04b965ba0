// SPDX-License-Identifier: MIT
// Which atoms stand for residues in an elastic network.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

inline constexpr std::uint32_t no_residue_node = ~std::uint32_t{0};

/// The nodes of a structure, as plain arrays.
struct ResidueNodes {
  std::vector<Vec3> positions;         ///< (M) Angstrom, of the atom at which each node is
  std::vector<std::uint32_t> chain;    ///< (M) nodes of one chain follow each other
  std::vector<std::uint32_t> of_atom;  ///< (N) the node that each atom goes with
  std::vector<std::uint32_t> atom;     ///< (M) at which each node is
  std::vector<bool> is_residue;        ///< (M) whether it stands for a residue of a polymer
};

/// A node at the alpha carbon of an amino acid, at P (else C4') of a nucleotide, at each heavy atom
/// of anything else; hydrogens of the latter go with the heavy atom they are bonded to. Of a
/// residue without any of these, such as a lone hydrogen, no atom has a node.
ResidueNodes residue_nodes(const Structure& structure);

}  // namespace pliant
