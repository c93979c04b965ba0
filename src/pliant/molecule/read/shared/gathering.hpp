// SPDX-License-Identifier: MIT
// Listed atoms put in order: residue by residue, chain by chain.
#pragma once

#include "pliant/molecule/read/shared/atom_sites.hpp"

namespace pliant {

/// Moves the columns of atoms, of which some may be left out, as reorder_atoms; not their residues.
void move_atoms(AtomSites& sites, const std::vector<std::uint32_t>& order);

/// Makes each run of `sites` that belongs to one residue part of it, and sets chain ends where
/// sections end. Returns the listed index of the atom at each place; empty if none has moved.
/// Warns of atoms that only distances assign to their residue.
std::vector<std::uint32_t> gather_residues(AtomSites& sites, Remarks& remarks);

/// Notes atoms that do not stand in the order of the file, `listed` their indices there, and keeps
/// that order.
void tell_of_order(AtomSites& sites, const std::vector<std::uint32_t>& listed, Remarks& remarks);

}  // namespace pliant
