// SPDX-License-Identifier: MIT
#include "pliant/run/run_summary.hpp"

#include <algorithm>

namespace pliant {

void add(RunSummary& sum, const RunSummary& more) {
  sum.steps += more.steps;
  sum.frames += more.frames;
  sum.sweeps += more.sweeps;
  sum.projections += more.projections;
  sum.unconverged_steps += more.unconverged_steps;
  if (sum.first_unconverged_step < 0) sum.first_unconverged_step = more.first_unconverged_step;
  sum.max_sweeps = std::max(sum.max_sweeps, more.max_sweeps);
  sum.seconds += more.seconds;
  sum.perturb_seconds += more.perturb_seconds;
  sum.resolve_seconds += more.resolve_seconds;
  sum.observe_seconds += more.observe_seconds;
  sum.stopped_by_caller = sum.stopped_by_caller || more.stopped_by_caller;
  if (more.worst_residual <= sum.worst_residual) return;
  sum.worst_residual = more.worst_residual;
  sum.worst_bar = more.worst_bar;
  sum.worst_joints = more.worst_joints;
  sum.worst_step = more.worst_step;
}

}  // namespace pliant
