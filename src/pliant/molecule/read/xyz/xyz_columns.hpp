// SPDX-License-Identifier: MIT
// The columns of an XYZ file: by default symbol, x, y, z; in extended XYZ given by the keys
// Properties and Lattice of the comment line (https://github.com/libAtoms/extxyz).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "pliant/molecule/structure/cell.hpp"

namespace pliant {

/// Columns count from 0; `fields` is the least number of columns in an atom line.
struct XyzColumns {
  std::size_t symbol = 0;
  std::size_t x = 1;
  std::size_t fields = 4;
};

/// The periodic cell in a comment line of extended XYZ: Lattice, the three edges one after another.
/// Nothing if there is none, or if pbc says that not all three directions are periodic. If Lattice
/// is not nine numbers, `problem` says so.
std::optional<Cell> cell_of_comment(std::string_view comment, std::string& problem);

/// The columns given by a comment line. If it looks like extended XYZ but is invalid, `problem`
/// says why and the default columns are returned.
XyzColumns columns_of_comment(std::string_view comment, std::string& problem);

}  // namespace pliant
