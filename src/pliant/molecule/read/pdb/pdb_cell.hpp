// SPDX-License-Identifier: MIT
// The periodic cell of a PDB file: CRYST1.
#pragma once

#include <optional>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/structure/cell.hpp"

namespace pliant {

/// The cell of a CRYST1 record: lengths in columns 7-33, angles in 34-54. Nothing for a dummy cell
/// such as 1 1 1 Angstrom; nothing and a warning where the columns are not six numbers.
std::optional<Cell> pdb_cell(const PdbLine& line, Remarks& remarks);

}  // namespace pliant
