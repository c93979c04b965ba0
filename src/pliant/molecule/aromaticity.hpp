// SPDX-License-Identifier: MIT
// Aromaticity: finds the bonds of aromatic rings, in whatever form a molecule is drawn.
#pragma once

#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// (M) Whether each of Structure::bonds is aromatic. It is if it has order 4 or is in an aromatic
/// ring: a ring of 5 to 7 atoms, or the outline of two or three such rings that share bonds, with
/// 4n + 2 pi electrons. A ring atom contributes one electron if it has a double bond to another
/// ring atom, whichever that is, so that all Kekule forms give the same result; two if it has a
/// lone pair instead (N, O, S, Se, Te; carbon of charge -1); none if it has a double bond out of
/// the rings to O, N or S (C=O of a pyridone), or is carbon of charge +1. A ring with any other
/// atom, an atom of more than three bonds or a bond of unknown order (0) is not aromatic. Linear in
/// the number of atoms.
std::vector<bool> find_aromatic_bonds(const Structure& structure);

}  // namespace pliant
