// SPDX-License-Identifier: MIT
// Pushes a square of bars a hundred times: all stay whole.
#include <cstdio>

#include "pliant/run/run.hpp"

int main() {
  const pliant::Framework framework(
      {.joint_count = 4, .bars = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, .rest_lengths = {1, 1, 1, 1}});
  pliant::State state({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  pliant::RunOptions options;
  options.steps = 100;
  const pliant::RunSummary summary = pliant::run(framework, state, options, {});
  std::printf("%lld steps, worst residual %g\n", static_cast<long long>(summary.steps),
              summary.worst_residual);
  return summary.steps == 100 && summary.unconverged_steps == 0 ? 0 : 1;
}
