// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/lab/generate/random_graphs.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace anderson_sweeps_test {

/// Graphs of every class with cycles, each pushed hard.
template <class Look>
void each_pushed_graph(Look look) {
  for (const GraphClass& kind : graph_classes()) {
    if (kind.family == "tree") continue;
    for (std::uint64_t number = 0; number < 20; ++number) {
      const GeneratedGraph graph =
          generate(kind, {.cycles = 4, .joints = 30},
                   {.seed = 5, .domain = Domain::generate, .walker = number});
      std::vector<Vec3> x = graph.positions;
      const auto root = static_cast<Joint>(number % x.size());
      x[root] += 3.0 * RandomSequence({number, Domain::force}).direction();
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(number));
      look(graph.framework, x, root);
    }
  }
}

ResolveSummary resolved_within(const Technique& technique, const Framework& framework,
                               std::vector<Vec3> x, Joint root) {
  ResolveOptions options;
  options.max_sweeps = 100000;
  return resolve(framework, technique, x, options, root);
}

/// The promise of AcceleratedSweeps: what P plain sweeps resolve takes at most 3 P + 50.
TEST(Anderson, IsNeverWorseThanPlainByMoreThanItsPromise) {
  each_pushed_graph([](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    for (double weighting : {0.5, 1.0}) {
      const auto plain = resolved_within({"bfs_cycle", weighting}, framework, x, root);
      const auto fast = resolved_within({"anderson", weighting}, framework, x, root);
      EXPECT_GE(fast.converged(), plain.converged());
      EXPECT_LE(fast.sweeps, 3 * plain.sweeps + 50) << weighting;
    }
  });
}

/// What it is for: it resolves all but a few of 140 pushed graphs with less work than plain sweeps,
/// and on the whole with less than half of it.
TEST(Anderson, NeedsLessWorkThanPlainSweeps) {
  std::int64_t plain_work = 0, fast_work = 0;
  int graphs = 0, less = 0;
  each_pushed_graph([&](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    const auto plain = resolved_within({"bfs_cycle", 0.5}, framework, x, root);
    const auto fast = resolved_within({"anderson", 0.5}, framework, x, root);
    plain_work += plain.projections;
    fast_work += fast.projections;
    ++graphs;
    less += fast.projections < plain.projections;
  });
  EXPECT_EQ(graphs, 140);
  EXPECT_GE(less, 137);
  EXPECT_LT(2 * fast_work, plain_work);
}

}  // namespace anderson_sweeps_test
}  // namespace pliant
