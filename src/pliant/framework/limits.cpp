// SPDX-License-Identifier: MIT
#include "pliant/framework/limits.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/choices.hpp"

namespace pliant {
namespace {

/// Kinds that share a number are written to files by the name of the first.
constexpr LimitKindEntry named[] = {
    {LimitKind::given, "given"},
    {LimitKind::torsion, "torsion"},
#define PLIANT_CONTACT_KIND(word, ...) {LimitKind::word, #word},
#include "pliant/framework/contact_kind_rows.hpp"
};

constexpr std::size_t number_of(LimitKind kind) { return static_cast<std::size_t>(kind); }

constexpr std::size_t numbers = [] {
  std::size_t last = 0;
  for (const LimitKindEntry& row : named) last = std::max(last, number_of(row.kind));
  return last + 1;
}();

constexpr std::array<LimitKindEntry, numbers> table = [] {
  std::array<LimitKindEntry, numbers> rows{};
  for (const LimitKindEntry& row : named)
    if (rows[number_of(row.kind)].name.empty()) rows[number_of(row.kind)] = row;
  return rows;
}();
static_assert(std::none_of(table.begin(), table.end(),
                           [](const LimitKindEntry& row) { return row.name.empty(); }),
              "numbers of kinds of limits leave one out");
static_assert(std::count_if(std::begin(named), std::end(named),
                            [](const LimitKindEntry& row) {
                              return row.kind == LimitKind::given || row.kind == LimitKind::torsion;
                            }) == 2,
              "a kind of contact has the number of `given` or `torsion`");

}  // namespace

std::span<const LimitKindEntry> limit_kinds() { return table; }

std::string_view name(LimitKind kind) { return table[static_cast<std::size_t>(kind)].name; }

LimitKind find_limit_kind(std::string_view name) {
  return choose(limit_kinds(), "kind of limit", name).kind;
}

}  // namespace pliant
