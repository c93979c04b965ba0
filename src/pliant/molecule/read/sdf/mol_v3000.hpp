// SPDX-License-Identifier: MIT
// The CTAB of a V3000 molfile.
#pragma once

#include "pliant/molecule/read/sdf/mol_block.hpp"

namespace pliant {

/// Reads the blocks after the V3000 counts line, which is the current line.
void read_mol_v3000(Lines& lines, MolBlock& block);

}  // namespace pliant
