// SPDX-License-Identifier: MIT
// The rows are in framework/contact_kind_rows.hpp, the finders in files beside this one.
#include "pliant/model/contacts/contact_kinds.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr MolecularContactKindEntry table[] = {
#define PLIANT_CONTACT_KIND(word, number, finder, ...) \
  {.kind = MolecularContactKind::word,                 \
   .name = #word,                                      \
   .limit = LimitKind::word,                           \
   .find = &finder,                                    \
   __VA_ARGS__},
#include "pliant/framework/contact_kind_rows.hpp"
};

constexpr std::size_t longest_name = 16;  // in arrays of Python
constexpr std::uint8_t most_bars = 6;

constexpr bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdef", 1) == text.npos;
}

/// Whether all that the others ask of a row is there.
constexpr bool is_whole(const MolecularContactKindEntry& row) {
  const bool is_named = row.name.size() <= longest_name && !row.singular.empty() &&
                        !row.plural.empty() && !row.summary.empty();
  return is_named && row.slack > 0.0 && row.bars >= 1 && row.bars <= most_bars &&
         is_colour(row.colour);
}
static_assert(
    std::all_of(std::begin(table), std::end(table), is_whole),
    "a kind of contact lacks a name, a slack, bars of 1 to 6 or a colour such as #3a9d8f");

constexpr bool has_colour_of_its_own(const MolecularContactKindEntry& row) {
  return std::count_if(std::begin(table), std::end(table),
                       [&](const auto& other) { return other.colour == row.colour; }) == 1;
}
static_assert(std::all_of(std::begin(table), std::end(table), has_colour_of_its_own),
              "two kinds of contacts have one colour");

}  // namespace

std::span<const MolecularContactKindEntry> molecular_contact_kinds() { return table; }

const MolecularContactKindEntry& entry(MolecularContactKind kind) {
  return table[static_cast<std::size_t>(kind)];
}

std::string_view name(MolecularContactKind kind) { return entry(kind).name; }

}  // namespace pliant
