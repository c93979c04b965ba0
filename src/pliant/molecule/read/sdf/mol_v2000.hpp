// SPDX-License-Identifier: MIT
// The atom and bond blocks of a V2000 molfile.
#pragma once

#include <string_view>

#include "pliant/molecule/read/sdf/mol_block.hpp"

namespace pliant {

/// Reads the blocks after the V2000 counts line, which is the current line.
void read_mol_v2000(Lines& lines, MolBlock& block);

/// Numbers of atoms and bonds in a V2000 counts line (three columns each).
struct MolCounts {
  std::size_t atoms = 0, bonds = 0;
};
bool parse_mol_counts(std::string_view line, MolCounts& counts);

}  // namespace pliant
