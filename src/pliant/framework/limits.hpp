// SPDX-License-Identifier: MIT
// Limits (inequality constraints; cables and struts of tensegrity): distances held to an interval.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/contact_kind_rows.hpp"

namespace pliant {

using LimitIndex = std::uint32_t;  ///< index of a limit, from 0

/// What a limit stands for. Its number is what files record.
enum class LimitKind : std::uint8_t {
  given = 0,
  torsion = 3,
#define PLIANT_CONTACT_KIND(name, number, ...) name = number,
#include "pliant/framework/contact_kind_rows.hpp"
};

/// One row of the table of kinds of limit.
struct LimitKindEntry {
  LimitKind kind;
  std::string_view name;  ///< "hydrogen_bond"
};

/// All kinds, in the order of their numbers.
std::span<const LimitKindEntry> limit_kinds();

/// "given", "hydrogen_bond", ...
std::string_view name(LimitKind kind);

/// The kind of that name. Throws OptionError listing the known names.
LimitKind find_limit_kind(std::string_view name);

/// kJ in a kcal: energies of molecular contacts are in kcal/mol, those of limits and of files of
/// frames in kJ/mol.
inline constexpr double kj_per_kcal = 4.184;

inline constexpr std::uint32_t no_limit_group = ~std::uint32_t{0};

/// Two joints whose distance is held to [least, most] Angstrom.
struct Limit {
  std::uint32_t a = 0, b = 0;                             ///< joints
  double least = 0.0;                                     ///< 0: a cable
  double most = std::numeric_limits<double>::infinity();  ///< infinite: a strut
  LimitKind kind = LimitKind::given;
  double energy = 0.0;                   ///< kJ/mol needed to break it; 0: not known
  std::uint32_t group = no_limit_group;  ///< limits with the same group stand for one contact
  friend bool operator==(const Limit&, const Limit&) = default;
};

/// How far `distance` is outside the interval: above 0 too long, below 0 too short, 0 within.
inline double excess(const Limit& limit, double distance) {
  if (distance > limit.most) return distance - limit.most;
  return distance < limit.least ? distance - limit.least : 0.0;
}

/// Which limits of a framework a walker has switched off: (L), 1 for off. Empty if all are on.
using LimitsOff = std::span<const std::uint8_t>;

inline bool is_off(LimitsOff off, LimitIndex limit) { return !off.empty() && off[limit] != 0; }

}  // namespace pliant
