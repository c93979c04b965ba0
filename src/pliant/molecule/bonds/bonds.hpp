// SPDX-License-Identifier: MIT
// Bond perception (bond guessing, connectivity): the file's bonds, residue templates, links between
// residues, and distances, merged.
#pragma once

#include "pliant/base/log.hpp"
#include "pliant/molecule/bonds/bond_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Adds to `structure.bonds` the bonds found by residue templates, links and distances. Existing
/// bonds are kept, but for those of metals to other residues, which are coordination
/// (coordination.hpp), and those longer than 1.3 times the sum of covalent radii, which a warning
/// names; long ones of metals and of SDF files stay, with a warning, too. Afterwards bonds are
/// sorted by (a, b) without repetition. Linear in the number of atoms. A molecule that the periodic
/// cell cuts is made whole: its atoms are moved by edges of the cell until all its bonds are short;
/// a note says so. Other positions do not change.
void perceive_bonds(Structure& structure, const BondOptions& options = {});

/// Makes molecules whole along the bonds that `structure` has. Returns whether any atom was moved.
bool make_whole(Structure& structure, const Log& log = {});

}  // namespace pliant
