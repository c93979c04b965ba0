// SPDX-License-Identifier: MIT
// Planar groups: bonds about which nothing turns, and the bars that hold their torsions.
#pragma once

#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Places in Structure::bonds of the bonds about which nothing turns, as far as the orders of bonds
/// say (from the file, or the template of a residue): double bonds, those of aromatic rings
/// (find_aromatic_bonds: the same for all Kekule forms), and bonds from nitrogen to a carbon that
/// has a double bond to O, S or N (amides, guanidinium, amidines); and peptide bonds. A double bond
/// to N in an aromatic ring makes no amidine: the ring turns about its bond to NH-R or NR2, but NH2
/// stays in its plane (bases). Without those at whose ends nothing hangs, and those in rings of up
/// to six atoms, whose angles hold them.
std::vector<std::size_t> find_planar_bonds(const Structure& structure);

/// For each of Structure::bonds, whether nothing turns about it: the bonds above, those at whose
/// ends nothing hangs and those in rings included, and triple bonds.
std::vector<bool> find_locked_bonds(const Structure& structure);

/// For each planar bond a pair of atoms bonded to its two ends (1-4), of those that are neither
/// bonded nor bonded to one atom the pair furthest apart (the first of such): each pair once, a <
/// b, sorted. A bar between them keeps the torsion that the structure has, cis or trans: with the
/// bars across angles the group is one rigid unit.
std::vector<Bar> find_planar_bars(const Structure& structure);

}  // namespace pliant
