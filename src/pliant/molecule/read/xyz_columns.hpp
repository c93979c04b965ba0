// SPDX-License-Identifier: MIT
// Which column of an XYZ file holds what: by default symbol, x, y, z; in extended XYZ as the key
// Properties of the comment line says (https://github.com/libAtoms/extxyz).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pliant {

/// Columns count from 0; `fields` is how many an atom line must have at least.
struct XyzColumns {
  std::size_t symbol = 0;
  std::size_t x = 1;
  std::size_t fields = 4;
};

/// The columns that a comment line asks for. Where it looks like extended XYZ but cannot be
/// followed, `problem` says why and the default columns are returned.
XyzColumns columns_of_comment(std::string_view comment, std::string& problem);

}  // namespace pliant
