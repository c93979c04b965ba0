// SPDX-License-Identifier: MIT
// Summary of a run: steps, sweeps, the worst bar, the time that it took.
#pragma once

#include <cstdint>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// What a run did.
struct RunSummary {
  std::int64_t steps = 0, frames = 0;
  std::int64_t unconverged_steps = 0;  ///< steps that did not end with Stop::converged
  std::int64_t first_unconverged_step = -1;
  /// over all steps, without the resolve of a broken start
  std::int64_t sweeps = 0, max_sweeps = 0;
  std::int64_t projections = 0;  ///< over all resolves, as resolve_seconds
  double worst_residual = 0.0;   ///< largest |length - rest| / rest after any step
  BarIndex worst_bar = 0;        ///< of the framework then: edits change which bars there are
  Bar worst_joints = {};         ///< its joints; both 0 where no bar was worse than 0
  std::int64_t worst_step = 0;
  bool stopped_by_caller = false;
  double perturb_seconds = 0.0, resolve_seconds = 0.0, observe_seconds = 0.0, seconds = 0.0;

  double mean_sweeps() const { return steps > 0 ? double(sweeps) / double(steps) : 0.0; }
  /// Resolve time divided by projections (nanoseconds a bar and sweep), measuring residuals
  /// included.
  double ns_per_bar_and_sweep() const {
    return projections > 0 ? 1e9 * resolve_seconds / double(projections) : 0.0;
  }
};

/// Adds `more` to `sum`: of another walker, or of later steps of the same.
void add(RunSummary& sum, const RunSummary& more);

}  // namespace pliant
