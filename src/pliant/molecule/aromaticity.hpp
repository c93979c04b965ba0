// SPDX-License-Identifier: MIT
// Aromaticity: which bonds are of aromatic rings, however the molecule is drawn.
#pragma once

#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// (M) For each of Structure::bonds, whether it is of an aromatic ring: a bond of any ring that is
/// stated so (order 4), or of a ring of 5 to 7 atoms, or of the outline of two or three such rings
/// that share bonds, with 4n + 2 pi electrons.
/// An atom of the ring counts one electron where it has a double bond to another ring atom,
/// whichever it is: so all Kekule forms give the same. It counts two where it has a lone pair
/// instead (N, O, S, Se, Te; carbon of charge -1), none where it has a double bond to O, N or S
/// out of the rings (C=O of a pyridone), or is carbon of charge +1. Any other atom, and one of more
/// than three bonds or with a bond of unknown order (0), makes the ring no aromatic one.
/// Linear in the number of atoms.
std::vector<bool> find_aromatic_bonds(const Structure& structure);

}  // namespace pliant
