// SPDX-License-Identifier: MIT
#include "pliant/base/choices.hpp"

#include <algorithm>
#include <numeric>

namespace pliant {
namespace {

/// A name that was removed. Old files, scripts and commands still say it.
struct RemovedChoice {
  std::string_view name;
  std::string_view version;  ///< the first without it
  std::string_view instead;
};

constexpr RemovedChoice removed_choices[] = {
    {"bfs_local", "0.3.0", "blocks"},
    {"rings_first", "0.3.0", "blocks, or anderson if there are limits"},
    {"rings_anderson", "0.3.0", "blocks, or anderson if there are limits"},
    {"torsions_preferred", "0.3.0", "torsions"},
    {"torsions_uniform", "0.3.0", "torsions"},
};

}  // namespace

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
  for (const auto& [name, version, instead] : removed_choices)
    if (name == word)
      return text.append(": removed in ").append(version).append("; use ").append(instead);
  const std::string near = nearest_name(word, names);
  if (!near.empty()) text += " (did you mean \"" + near + "\"?)";
  text += "; known:";
  for (std::size_t i = 0; i < names.size(); ++i) text.append(i == 0 ? " " : ", ").append(names[i]);
  return text;
}

}  // namespace pliant
