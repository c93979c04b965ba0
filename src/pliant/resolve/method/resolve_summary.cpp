// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/resolve_summary.hpp"

#include "pliant/base/number.hpp"

namespace pliant {

std::string ResolveSummary::brief(const Framework& framework) const {
  std::string text = std::string(name(stop)) + ": " + std::to_string(sweeps) + " sweeps, " +
                     std::to_string(projections) + " projections";
  if (framework.bar_count() == 0) return text;
  text += ", worst bar " + framework.label(framework.bars()[worst_bar]) + " off by " +
          number_text(max_residual, 2) + " of its length";
  if (finishing_sweeps > 0)
    text += "; the last " + std::to_string(finishing_sweeps) + " sweeps finished what was left";
  if (dropped_bars > 0) text += "; dependent bars left out: " + std::to_string(dropped_bars);
  return text;
}

}  // namespace pliant
