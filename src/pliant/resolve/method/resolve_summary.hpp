// SPDX-License-Identifier: MIT
// Summary of a resolve: why it stopped, its accuracy, its cost.
#pragma once

#include <cstdint>
#include <string>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// What a resolve did. Numbers start at -1, which means "never ran".
struct ResolveSummary {
  Stop stop = Stop::stopped_by_caller;
  std::int64_t sweeps = -1;       ///< passes over the ordering in one direction
  std::int64_t projections = -1;  ///< bars looked at, summed over the sweeps
  double max_residual = -1.0;     ///< largest |length - rest| / rest at the end
  double rms_residual = -1.0;     ///< its root mean square at the end
  BarIndex worst_bar = 0;         ///< the bar of max_residual
  double seconds = -1.0;          ///< wall time
  /// Direct methods: bars left out of the last equations because they depend on others.
  std::int64_t dropped_bars = -1;
  /// Direct methods: sweeps, among `sweeps`, that finished what the method could not.
  std::int64_t finishing_sweeps = -1;
  /// `newton`: the largest move towards the nearest whole positions that remained at the last check
  /// (Angstrom), before the last move was made.
  double off_nearest = -1.0;

  double max_limit = -1.0;     ///< largest distance of a limit outside its interval (Angstrom)
  LimitIndex worst_limit = 0;  ///< the limit of max_limit
  double max_overlap = -1.0;   ///< largest overlap of two joints (Angstrom)
  Bar worst_overlap = {};      ///< the joints of max_overlap

  bool converged() const { return stop == Stop::converged; }
  /// "converged: 12 sweeps, 300 projections, worst bar C1 - C2 off by 8.1e-07 of its length".
  std::string brief(const Framework& framework) const;
};

/// Copies the limits and overlaps of `measured`.
void note_violations(const ResidualSummary& measured, ResolveSummary& summary);

}  // namespace pliant
