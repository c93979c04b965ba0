// SPDX-License-Identifier: MIT
// The periodic cell of a PDB file: CRYST1.
#pragma once

#include <optional>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/structure/cell.hpp"

namespace pliant {

/// The cell of a CRYST1 record: lengths in columns 7-33, angles in 34-54. Nothing where it is none,
/// as that of 1 1 1 Angstrom; with a warning where its columns are not six numbers.
std::optional<Cell> pdb_cell(const PdbLine& line, Remarks& remarks);

}  // namespace pliant
