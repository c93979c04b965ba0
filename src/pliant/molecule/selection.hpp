// SPDX-License-Identifier: MIT
// Selection language (atom selection): choosing atoms by words, as MDAnalysis' select_atoms does.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A word of the language that selects atoms.
struct SelectionWord {
  std::string_view name;
  std::string_view values;  ///< what follows it: "", "names", "numbers and ranges"
  std::string_view summary;
};

/// The words, for help texts. Beside them: and, or (same rank, from left to right), not (binds
/// tighter), parentheses.
std::vector<SelectionWord> selection_words();

/// The atoms (indices from 0, ascending) that `selection` names.
///
/// Words and meanings are MDAnalysis': "protein and not name H*", "resid 3-8 12 or index 0:4".
/// Names may hold * (any characters) and ? (any one); several values mean any of them; ranges a-b
/// or a:b include both ends; a residue number may carry its insertion code (52A), and plain 52 is
/// the residue without one. A name that is also a word is written with a backslash: name \\all.
/// Throws OptionError naming the word and the character (from 1) where it cannot be understood.
std::vector<std::uint32_t> select_atoms(const AtomTable& atoms, std::string_view selection);

/// The same for an option that must name at least one atom. Throws OptionError, which begins with
/// `option`, where it names none.
std::vector<std::uint32_t> select_some_atoms(const AtomTable& atoms, std::string_view selection,
                                             std::string_view option);

/// The joints that an option names; none where it is empty. Throws OptionError, which begins with
/// `option`, where the joints have no names, or it names none.
std::vector<Joint> select_joints(const Framework& framework, std::string_view selection,
                                 std::string_view option);

}  // namespace pliant
