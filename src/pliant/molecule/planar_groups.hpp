// SPDX-License-Identifier: MIT
// Planar groups: bonds that do not rotate, and the bars that keep their torsions.
#pragma once

#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Indices into Structure::bonds of the bonds that do not rotate, according to bond orders (from
/// the file, or from residue templates): double bonds, bonds of aromatic rings
/// (find_aromatic_bonds: the same for all Kekule forms), bonds from nitrogen to a carbon with a
/// double bond to O, S or N (amides, guanidinium, amidines), and peptide bonds. A double bond to N
/// in an aromatic ring makes no amidine: the bond of the ring to NH-R or NR2 rotates, but NH2 stays
/// in its plane (bases). Bonds with no further atom at an end are left out, as are those in rings
/// of up to six atoms, whose angles keep them.
std::vector<std::size_t> find_planar_bonds(const Structure& structure);

/// Whether each of Structure::bonds does not rotate: the bonds above, those left out there, and
/// triple bonds.
std::vector<bool> find_locked_bonds(const Structure& structure);

/// For each planar bond a pair of atoms bonded to its two ends (1-4): of the pairs that are neither
/// bonded nor bonded to one atom the first of those furthest apart. Each pair occurs once, with a <
/// b, sorted. A bar between them keeps the torsion of the structure, cis or trans: with the bars
/// across angles the group is one rigid unit.
std::vector<Bar> find_planar_bars(const Structure& structure);

}  // namespace pliant
