// SPDX-License-Identifier: MIT
#include "pliant/framework/limits.hpp"

#include <array>

#include "pliant/base/choices.hpp"

namespace pliant {
namespace {

constexpr std::array<LimitKindEntry, 4> table{{{LimitKind::given, "given"},
                                               {LimitKind::hydrogen_bond, "hydrogen_bond"},
                                               {LimitKind::hydrophobic, "hydrophobic"},
                                               {LimitKind::torsion, "torsion"}}};

}  // namespace

std::span<const LimitKindEntry> limit_kinds() { return table; }

std::string_view name(LimitKind kind) { return table[static_cast<std::size_t>(kind)].name; }

LimitKind find_limit_kind(std::string_view name) {
  return choose(limit_kinds(), "kind of limit", name).kind;
}

}  // namespace pliant
