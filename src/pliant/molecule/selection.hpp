// SPDX-License-Identifier: MIT
// Selection language (atom selection): selects atoms by words, as MDAnalysis' select_atoms does.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A keyword of the selection language.
struct SelectionWord {
  std::string_view name;
  std::string_view values;  ///< what follows it: "", "names", "numbers and ranges"
  std::string_view summary;
};

/// The keywords, for help texts. Besides them there are: and, or (same precedence, from left to
/// right), not (binds tighter), parentheses.
std::vector<SelectionWord> selection_words();

/// Returns the atoms (indices from 0, ascending) that match `selection`.
///
/// Keywords and meanings are those of MDAnalysis: "protein and not name H*", "resid 3-8 12 or index
/// 0:4". Names may contain * (any characters) and ? (any one); several values match any of them;
/// ranges a-b or a:b include both ends; a residue number may have an insertion code (52A), and
/// plain 52 is the residue without one. A name that is also a keyword is written with a backslash:
/// name \\all. Throws OptionError naming the word and the character (from 1) where the selection
/// is invalid.
std::vector<std::uint32_t> select_atoms(const AtomTable& atoms, std::string_view selection);

/// Returns the selected atoms of an option that needs at least one. Throws OptionError, which
/// begins with `option`, if there is none.
std::vector<std::uint32_t> select_some_atoms(const AtomTable& atoms, std::string_view selection,
                                             std::string_view option);

/// Returns the joints that an option selects; none if it is empty. Throws OptionError, which begins
/// with `option`, if the joints have no names, or none is selected.
std::vector<Joint> select_joints(const Framework& framework, std::string_view selection,
                                 std::string_view option);

}  // namespace pliant
