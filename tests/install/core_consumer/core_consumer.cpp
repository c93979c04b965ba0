// SPDX-License-Identifier: MIT
// Pushes a named framework a hundred times: all bars stay whole.
#include <cstdio>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/run.hpp"

int main() {
  const pliant::Sketch sketch = pliant::ring(6);
  const pliant::Framework framework = pliant::framework_of(sketch);
  pliant::State state(sketch.positions);
  pliant::RunOptions options;
  options.steps = 100;
  const pliant::RunSummary summary = pliant::run(framework, state, options, {});
  std::printf("%lld steps, worst residual %g\n", static_cast<long long>(summary.steps),
              summary.worst_residual);
  return summary.steps == 100 && summary.unconverged_steps == 0 ? 0 : 1;
}
