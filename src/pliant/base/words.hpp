// SPDX-License-Identifier: MIT
// The words of a line of the text files that are ours: set apart by blanks, with "#" beginning a
// comment.
#pragma once

#include <string_view>
#include <vector>

namespace pliant {

using Words = std::vector<std::string_view>;

/// Views into `line`, in their order; a carriage return is a blank.
Words words_of(std::string_view line);

/// Whether a text is read back as one word: not empty, no blank and no "#" in it.
bool is_word(std::string_view text);

}  // namespace pliant
