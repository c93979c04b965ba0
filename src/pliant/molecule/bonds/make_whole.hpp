// SPDX-License-Identifier: MIT
// Molecules that their periodic cell cuts, made whole: a step of bond perception. Not for users:
// see bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Moves atoms of `structure`, whose bonds `perception` has found, along edges of its cell until
/// the bonds through the faces of the cell (cell_bonds) are as short as the others. Of each
/// molecule the larger part stays. What has no such bond is not moved, nor what is bonded to its
/// own image, as a crystal is. Notes what was moved. True if anything was; the bonds are then to be
/// found anew. Linear.
bool make_whole(Structure& structure, const Perception& perception);

}  // namespace pliant::perception
