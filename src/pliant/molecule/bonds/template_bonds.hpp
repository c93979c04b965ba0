// SPDX-License-Identifier: MIT
// Bonds within residues that templates know: a step of bond perception. Not for users: see
// bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Splits residues into pieces and bonds the atoms that templates know.
void add_template_bonds(Perception& perception);

}  // namespace pliant::perception
