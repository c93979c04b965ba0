// SPDX-License-Identifier: MIT
// Bond perception (bond guessing, connectivity): the file's bonds, residue templates, links between
// residues, and distances, merged.
#pragma once

#include "pliant/base/log.hpp"
#include "pliant/molecule/bonds/bond_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Adds to `structure.bonds` what residue templates, links and distances tell; the bonds that are
/// there stay. Linear in the number of atoms. Afterwards bonds are sorted by (a, b), each once.
/// A molecule that the structure's periodic cell cuts is made whole: its atoms are moved by edges
/// of the cell until all of its bonds are short, which a note tells. Other positions stay.
void perceive_bonds(Structure& structure, const BondOptions& options = {});

/// The last of this alone: makes molecules whole along the bonds that `structure` has. True if any
/// atom was moved.
bool make_whole(Structure& structure, const Log& log = {});

}  // namespace pliant
