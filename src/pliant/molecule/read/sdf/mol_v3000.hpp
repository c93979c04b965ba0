// SPDX-License-Identifier: MIT
// The CTAB of a V3000 molfile.
#pragma once

#include "pliant/molecule/read/sdf/mol_block.hpp"

namespace pliant {

/// Reads what follows the counts line (the current one), V3000.
void read_mol_v3000(Lines& lines, MolBlock& block);

}  // namespace pliant
