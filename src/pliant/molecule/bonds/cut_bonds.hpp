// SPDX-License-Identifier: MIT
// Detects molecules cut by a periodic box.
#pragma once

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// What is shorter (Angstrom) may be a bad bond, or an atom whose name means another; a box is
/// wider.
inline constexpr double longest_bad_bond = 10.0;

/// Throws InputError naming the longest bond, its length and what to do, if a bond of the structure
/// or of a residue template is longer than 10 Angstrom: the bonds of a molecule cannot be
/// recognized at such positions. Bonds of atoms without an element, as in coarse models, may have
/// any length. Linear.
void refuse_cut(const Structure& structure);

}  // namespace pliant
