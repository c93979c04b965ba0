// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/atom_words.hpp"

#include "pliant/base/number.hpp"

namespace pliant {

AtomWords::AtomWords(const AtomTable& atoms) : atoms_(atoms) {
  for (std::uint32_t i = 0; i < atoms.size(); ++i) {
    std::string label = atoms.label(i);
    const auto [row, is_new] = atom_of_.emplace(std::move(label), i);
    if (!is_new) ++repeats_.emplace(row->first, std::size_t{1}).first->second;
  }
}

std::string AtomWords::word_for(std::uint32_t atom) const {
  const std::string label = atoms_.label(atom);
  const bool is_word = label.find_first_of(", \t\"#") == std::string::npos && !parse_integer(label);
  return is_word && !repeats_.contains(label) ? label : std::to_string(atom);
}

std::uint32_t AtomWords::find(std::string_view word, const Place& place) const {
  const std::string label(word);
  if (const auto repeated = repeats_.find(label); repeated != repeats_.end())
    fail(place, std::to_string(repeated->second) + " atoms are called " + quoted(word) +
                    ": say the index of one");
  if (const auto at = atom_of_.find(label); at != atom_of_.end()) return at->second;
  const auto index = parse_integer(word);
  if (!index) fail(place, "there is no atom called " + quoted(word));
  if (*index < 0 || *index >= static_cast<std::int64_t>(atoms_.size()))
    fail(place, "there is no atom " + quoted(word) + ": there are " +
                    std::to_string(atoms_.size()) + ", counted from 0");
  return static_cast<std::uint32_t>(*index);
}

}  // namespace pliant
