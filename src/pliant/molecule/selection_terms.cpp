// SPDX-License-Identifier: MIT
#include "pliant/molecule/selection_terms.hpp"

#include <cctype>

#include "pliant/base/elements.hpp"

namespace pliant {
namespace selection {
namespace {

bool is_any(const Subject&, std::size_t) { return true; }
bool is_none(const Subject&, std::size_t) { return false; }
bool is_protein(const Subject& s, std::size_t i) { return s.is_protein(i); }
bool is_nucleic(const Subject& s, std::size_t i) { return s.is(i, ResidueKind::nucleotide); }
bool is_water(const Subject& s, std::size_t i) { return s.is(i, ResidueKind::water); }
bool is_backbone(const Subject& s, std::size_t i) {
  const std::string_view name = s.atoms.names[i];
  return s.is_protein(i) && (name == "N" || name == "CA" || name == "C" || name == "O");
}

std::string_view name_of(const Subject& s, std::size_t i) { return s.atoms.names[i]; }
std::string_view element_of(const Subject& s, std::size_t i) {
  return element_symbol(s.atoms.elements[i]);
}
std::string_view resname_of(const Subject& s, std::size_t i) { return s.residue(i).name; }
std::string_view chain_of(const Subject& s, std::size_t i) { return s.residue(i).chain; }

Number resid_of(const Subject& s, std::size_t i) {
  return {s.residue(i).number, s.residue(i).insertion_code};
}
Number index_of(const Subject&, std::size_t i) { return {static_cast<std::int64_t>(i), ' '}; }
Number bynum_of(const Subject&, std::size_t i) { return {static_cast<std::int64_t>(i) + 1, ' '}; }

constexpr std::string_view ranges = "numbers and ranges";

constexpr Term terms[] = {
    {{"all", "", "every atom"}, {.holds = is_any}},
    {{"none", "", "no atom"}, {.holds = is_none}},
    {{"protein", "", "amino acids and the caps of their chains"}, {.holds = is_protein}},
    {{"backbone", "", "atoms N, CA, C and O of protein"}, {.holds = is_backbone}},
    {{"nucleic", "", "nucleotides"}, {.holds = is_nucleic}},
    {{"water", "", "water molecules"}, {.holds = is_water}},
    {{"name", "names", "atoms so called"}, {.text = name_of}},
    {{"id", "names", "joints of a graph, by their id in its XML"}, {.text = name_of}},
    {{"element", "names", "elements, in capitals or not"}, {.text = element_of}},
    {{"resname", "names", "residues so called"}, {.text = resname_of}},
    {{"chainID", "names", "chains so called"}, {.text = chain_of}},
    {{"segid", "names", "the same as chainID"}, {.text = chain_of}},
    {{"resid", ranges, "residues with these numbers"}, {.number = resid_of}},
    {{"index", ranges, "atoms by their place in the file, from 0"}, {.number = index_of}},
    {{"bynum", ranges, "atoms by their place in the file, from 1"}, {.number = bynum_of}}};

}  // namespace

const Term* find_term(std::string_view word) {
  for (const Term& term : terms)
    if (term.word.name == word) return &term;
  return nullptr;
}

/// On a mismatch only the last * is tried again: an earlier one could not do better.
bool fits(std::string_view pattern, std::string_view text, bool any_case) {
  const auto same = [&](char p, char t) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return p == '?' || p == t || (any_case && lower(p) == lower(t));
  };
  constexpr auto none = std::string_view::npos;
  std::size_t p = 0, t = 0, star = none, star_text = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_text = t;
    } else if (p < pattern.size() && same(pattern[p], text[t])) {
      ++p;
      ++t;
    } else if (star != none) {
      p = star + 1;
      t = ++star_text;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == none;
}

}  // namespace selection

std::vector<SelectionWord> selection_words() {
  std::vector<SelectionWord> words;
  for (const selection::Term& term : selection::terms) words.push_back(term.word);
  return words;
}

}  // namespace pliant
