// SPDX-License-Identifier: MIT
// Drawings: structural formulas in a plane, with bonds of one length and no third dimension.
#pragma once

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Whether a structure is a drawing rather than a flat molecule such as benzene. All z are 0, there
/// are more than three atoms, and the file does not say that it is 3-D. In addition one of these
/// holds: the bonds do not have the lengths of bonds (within 0.15 Angstrom of
/// standard_bond_length); a carbon with only single bonds has three or more of them in the plane;
/// or the file says 2-D, and shows no hydrogen and bonds of one length. Linear.
bool is_drawing(const Structure& structure);

/// Throws InputError, which says how to make a 3-D structure, if the structure is a drawing.
void refuse_drawing(const Structure& structure);

}  // namespace pliant
