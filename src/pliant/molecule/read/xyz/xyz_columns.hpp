// SPDX-License-Identifier: MIT
// Which column of an XYZ file holds what: by default symbol, x, y, z; in extended XYZ as the keys
// Properties and Lattice of the comment line say (https://github.com/libAtoms/extxyz).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "pliant/molecule/structure/cell.hpp"

namespace pliant {

/// Columns count from 0; `fields` is how many an atom line must have at least.
struct XyzColumns {
  std::size_t symbol = 0;
  std::size_t x = 1;
  std::size_t fields = 4;
};

/// The periodic cell that a comment line of extended XYZ states: Lattice, the three edges one after
/// the other. Nothing where there is none, or pbc says that not all three directions are periodic.
/// Where Lattice is not nine numbers, `problem` says so.
std::optional<Cell> cell_of_comment(std::string_view comment, std::string& problem);

/// The columns that a comment line asks for. Where it looks like extended XYZ but cannot be
/// followed, `problem` says why and the default columns are returned.
XyzColumns columns_of_comment(std::string_view comment, std::string& problem);

}  // namespace pliant
