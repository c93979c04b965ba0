// SPDX-License-Identifier: MIT
// Bonds within residues that have templates: a step of bond perception. Internal: users call
// bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Splits residues into pieces and adds the bonds of their templates.
void add_template_bonds(Perception& perception);

}  // namespace pliant::perception
