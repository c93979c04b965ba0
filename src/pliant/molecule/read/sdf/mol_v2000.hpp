// SPDX-License-Identifier: MIT
// The atom and bond blocks of a V2000 molfile.
#pragma once

#include <string_view>

#include "pliant/molecule/read/sdf/mol_block.hpp"

namespace pliant {

/// Reads what follows the counts line (the current one): `counts` from it, V2000.
void read_mol_v2000(Lines& lines, MolBlock& block);

/// Atoms and bonds of a V2000 counts line (three columns each).
struct MolCounts {
  std::size_t atoms = 0, bonds = 0;
};
bool parse_mol_counts(std::string_view line, MolCounts& counts);

}  // namespace pliant
