// SPDX-License-Identifier: MIT
#include "pliant/framework/frame.hpp"

namespace pliant {
namespace {

constexpr DrawnByEntry drawn_by_rows[] = {
    {DrawnBy::other, "other", true},
    {DrawnBy::modes, "modes", true},
    {DrawnBy::wide_modes, "wide_modes", false},
    {DrawnBy::turns, "turns", false},
    {DrawnBy::turns_with_modes, "turns_with_modes", false},
    {DrawnBy::pocket, "pocket", false},
    {DrawnBy::ligand, "ligand", false},
};

constexpr bool are_by_number(std::span<const DrawnByEntry> rows) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].drawn_by != static_cast<DrawnBy>(k)) return false;
  return true;
}
static_assert(are_by_number(drawn_by_rows));

}  // namespace

std::string_view name(Stop stop) {
  switch (stop) {
    case Stop::converged:
      return "converged";
    case Stop::max_sweeps:
      return "max_sweeps";
    case Stop::not_finite:
      return "not_finite";
    case Stop::stopped_by_caller:
      return "stopped_by_caller";
  }
  return "unknown";
}

std::span<const DrawnByEntry> drawn_by_table() { return drawn_by_rows; }

}  // namespace pliant
