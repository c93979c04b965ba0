// SPDX-License-Identifier: MIT
// Which atoms of a list are one residue, wherever they stand in it.
#pragma once

#include "pliant/molecule/structure/listed_residues.hpp"

namespace pliant {

/// The residues of N listed atoms.
struct ResidueCopies {
  std::vector<std::uint32_t> leader;  ///< (N) the first atom of the residue of each atom
  /// Atoms that distances assign: parts of several residues of one name stand apart. Ascending.
  std::vector<std::uint32_t> by_distance;
};

/// Atoms that agree in chain, segment, number, insertion code and name are one residue, wherever
/// they stand, unless names of heavy atoms repeat: then these are copies, as in files without
/// chains, or with numbers that start again or are all alike. A copy begins where the name of the
/// first atom comes again, at least 2 Angstrom away. Where parts of copies stand apart, as
/// hydrogens at the end of the file, bonding distances tell which is whose. Names that only repeat
/// the element tell nothing. Linear, but for those copies: O(n log n).
ResidueCopies residue_copies(const ListedResidues& listed);

}  // namespace pliant
