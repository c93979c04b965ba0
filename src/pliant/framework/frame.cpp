// SPDX-License-Identifier: MIT
#include "pliant/framework/frame.hpp"

namespace pliant {

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

std::string_view name(DrawnBy drawn_by) {
  constexpr std::string_view names[drawn_by_count] = {
      "other", "modes", "wide_modes", "turns", "turns_with_modes", "pocket"};
  return names[static_cast<std::size_t>(drawn_by)];
}

}  // namespace pliant
