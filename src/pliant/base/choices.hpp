// SPDX-License-Identifier: MIT
// Tables of named things: one row a choice, found by name, listed in error messages and help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/error.hpp"

namespace pliant {

/// Number of single-character insertions, deletions and replacements from `a` to `b` (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name in `names` nearest to `word`, or "" when none is within a third of its length.
std::string nearest_name(std::string_view word, const std::vector<std::string_view>& names);

/// "no ordering named "bsf_cycle" (did you mean "bfs_cycle"?); known: random, bfs_tree, ...". Of a
/// name that earlier versions knew: since when it is gone, and what replaces it.
std::string unknown_choice(std::string_view kind, std::string_view word,
                           const std::vector<std::string_view>& names);

template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& row : table) names.push_back(row.name);
  return names;
}

/// The row of `table` (rows have a `name`) called `word`.
/// Throws OptionError listing the known names and the nearest one.
template <class Table>
const auto& choose(const Table& table, std::string_view kind, std::string_view word) {
  for (const auto& row : table)
    if (row.name == word) return row;
  throw OptionError(unknown_choice(kind, word, names_of(table)));
}

}  // namespace pliant
