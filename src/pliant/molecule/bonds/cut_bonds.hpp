// SPDX-License-Identifier: MIT
// Molecules that a periodic box has cut, and that nothing has made whole.
#pragma once

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Throws InputError naming the longest bond, its length and what to do, if a bond of the structure
/// or of a residue template is longer than 10 Angstrom: what holds a molecule cannot be told from
/// such positions. Bonds of atoms without an element, as of coarse models, may be of any length.
/// Linear.
void refuse_cut(const Structure& structure);

}  // namespace pliant
