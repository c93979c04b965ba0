// SPDX-License-Identifier: MIT
// Makes molecules whole that their periodic cell cuts: a step of bond perception. Internal: users
// call bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Moves atoms of `structure`, whose bonds `perception` has found, along edges of its cell until
/// the bonds through the faces of the cell (cell_bonds) are as short as the others. The larger part
/// of each molecule does not move, nor do molecules without such a bond, nor atoms bonded to their
/// own images, as in a crystal. Notes what was moved. Returns whether anything was; its bonds must
/// then be perceived again. Linear.
bool make_whole(Structure& structure, const Perception& perception);

}  // namespace pliant::perception
