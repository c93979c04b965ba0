// SPDX-License-Identifier: MIT
// Fixed columns of a line, counted from 1 as in the definitions of formats.
#pragma once

#include <cstddef>
#include <string_view>

namespace pliant {

/// Columns `first` to `last`; shorter where the line ends before.
constexpr std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  return line.size() < first ? std::string_view() : line.substr(first - 1, last - first + 1);
}

/// One column; ' ' where the line ends before.
constexpr char column(std::string_view line, std::size_t at) {
  return line.size() < at ? ' ' : line[at - 1];
}

}  // namespace pliant
