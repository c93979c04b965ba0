// SPDX-License-Identifier: MIT
// Hydrogen bonds and salt bridges of a structure, by distance, angles and energy
// (hydrogen_bond_energy.hpp).
#pragma once

#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/contact_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The hydrogen bonds and salt bridges of a structure whose bonds are known and which has its polar
/// hydrogens: one bond a hydrogen (the best), one salt bridge a pair of donor and acceptor.
/// R <= 3.9, H..A <= 2.6 Angstrom, theta >= 100, phi >= 80 degrees; salt bridges R <= 4.0 Angstrom,
/// theta and phi >= 80 degrees. Donor (N, O) and acceptor (O; N with two neighbours or fewer) are
/// more than two bonds apart. Salt bridges are between N with a charge (Lys, Arg, His with two
/// hydrogens, the begin of a chain) and O of carboxylate or phosphate, or as formal charges of the
/// file say. Sorted; linear in the number of atoms.
std::vector<MolecularContact> hydrogen_bonds(const Structure& structure,
                                             const HydrogenBondOptions& options = {});

}  // namespace pliant
