// SPDX-License-Identifier: MIT
// The words of a line of Pliant's own text files, separated by blanks; "#" begins a comment.
#pragma once

#include <string_view>
#include <vector>

namespace pliant {

using Words = std::vector<std::string_view>;

/// Views into `line`, in their order; a carriage return is a blank.
Words words_of(std::string_view line);

/// Whether `text` is read back as one word: it is not empty and has no blank and no "#" in it.
bool is_word(std::string_view text);

}  // namespace pliant
