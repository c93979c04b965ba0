// SPDX-License-Identifier: MIT
#include "pliant/base/words.hpp"

#include <algorithm>

namespace pliant {

Words words_of(std::string_view line) {
  Words words;
  line = line.substr(0, line.find('#'));
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t start = line.find_first_not_of(" \t\r", i);
    if (start == std::string_view::npos) break;
    i = std::min(line.find_first_of(" \t\r", start), line.size());
    words.push_back(line.substr(start, i - start));
  }
  return words;
}

bool is_word(std::string_view text) {
  return !text.empty() && text.find_first_of(" \t\r\n#") == std::string_view::npos;
}

}  // namespace pliant
