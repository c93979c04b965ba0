// SPDX-License-Identifier: MIT
// The order in which a structure has listed atoms: residue by residue, chain by chain.
#pragma once

#include <utility>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/listed_residues.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// N listed atoms as R residues in order.
struct ResidueOrder {
  std::vector<std::uint32_t> order;       ///< (N) the listed atom at each place
  std::vector<std::uint32_t> residue_of;  ///< (N) residue of the atom at each place
  std::vector<std::uint32_t> leaders;     ///< (R) a listed atom of each: its first
  /// Listed atoms that only distances assign to one of several residues of one name.
  std::vector<std::uint32_t> by_distance;
};

/// Puts the atoms of each residue (residue_copies) one after another, in the order of the list, and
/// residues in the order of their first atoms. Two things change that: where waters or other chains
/// stand between neighbours of a polymer, these are put together; where more than half of its
/// residues do not follow each other's numbers, and would if sorted, or heavy atoms of different
/// residues are mixed, it is sorted by number and insertion code. Linear, but for what is shuffled.
ResidueOrder order_residues(const ListedResidues& listed);

/// Moves one column of N atoms, of which some may be left out; an empty one stays empty.
template <class Column>
void reorder(Column& column, const std::vector<std::uint32_t>& order) {
  if (column.empty()) return;
  Column moved;
  moved.reserve(order.size());
  for (const std::uint32_t at : order) moved.push_back(std::move(column[at]));
  column = std::move(moved);
}

/// Moves the atoms of a structure, and the ends of its bonds; residues stay as they are. Atoms
/// without bonds may be left out.
void reorder_atoms(Structure& structure, const std::vector<std::uint32_t>& order);

/// Puts the atoms of a structure into the order of order_residues, and notes in `log` if any has
/// moved. Bonds, chain ends and `source_order` follow.
void gather_residues(Structure& structure, const Log& log = {});

}  // namespace pliant
