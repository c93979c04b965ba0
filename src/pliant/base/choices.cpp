// SPDX-License-Identifier: MIT
#include "pliant/base/choices.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replace = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replace, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view word, const std::vector<std::string_view>& names) {
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (std::string_view name : names) {
    const std::size_t d = edit_distance(word, name);
    if (d < best_distance) {
      best = name;
      best_distance = d;
    }
  }
  return std::string(best);
}

std::string unknown_choice(std::string_view kind, std::string_view word,
                           const std::vector<std::string_view>& names) {
  std::string text = "no " + std::string(kind) + " named " + quoted(word);
  const std::string near = nearest_name(word, names);
  if (!near.empty()) text += " (did you mean \"" + near + "\"?)";
  text += "; known:";
  for (std::size_t i = 0; i < names.size(); ++i) text.append(i == 0 ? " " : ", ").append(names[i]);
  return text;
}

}  // namespace pliant
