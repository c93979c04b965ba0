// SPDX-License-Identifier: MIT
// Which bonds of the file are bonds: a step of bond perception. Internal: users call bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Takes out of the bonds of the file those of metals to other residues, which are coordination,
/// and those that are longer than 1.3 times the sum of covalent radii. Long ones of a metal stay,
/// and so do all of an SDF file, which states every bond, and those beyond 10 Angstrom within a
/// residue, by which a molecule that a box cuts is known. Bonds of unknown elements may have any
/// length, and those of a flat drawing.
void judge_stated_bonds(Perception& perception);

}  // namespace pliant::perception
