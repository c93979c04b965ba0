// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/resolve_summary.hpp"

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

std::string bar_text(const ResolveSummary& summary, const Framework& framework) {
  return ", worst bar " + framework.label(framework.bars()[summary.worst_bar]) + " off by " +
         number_text(summary.max_residual, 2) + " of its length";
}

/// Only what is violated is worth a word.
std::string limit_text(const ResolveSummary& summary, const Framework& framework) {
  std::string text;
  if (summary.max_limit > 0.0) {
    const Limit& limit = framework.limits()[summary.worst_limit];
    text += ", worst limit " + framework.label(Bar{limit.a, limit.b}) + " off by " +
            number_text(summary.max_limit, 2) + " Angstrom";
  }
  if (summary.max_overlap > 0.0)
    text += ", worst overlap " + framework.label(summary.worst_overlap) + " of " +
            number_text(summary.max_overlap, 2) + " Angstrom";
  return text;
}

}  // namespace

std::string ResolveSummary::brief(const Framework& framework) const {
  std::string text = std::string(name(stop)) + ": " + std::to_string(sweeps) + " sweeps, " +
                     std::to_string(projections) + " projections";
  if (framework.bar_count() > 0) text += bar_text(*this, framework);
  text += limit_text(*this, framework);
  if (finishing_sweeps > 0)
    text += "; the last " + std::to_string(finishing_sweeps) + " sweeps finished what was left";
  if (dropped_bars > 0) text += "; dependent bars left out: " + std::to_string(dropped_bars);
  return text;
}

void note_violations(const ResidualSummary& measured, ResolveSummary& summary) {
  summary.max_limit = measured.max_limit;
  summary.worst_limit = measured.worst_limit;
  summary.max_overlap = measured.max_overlap;
  summary.worst_overlap = measured.worst_overlap;
}

}  // namespace pliant
