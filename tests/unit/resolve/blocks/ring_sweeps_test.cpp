// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/ring_sweeps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pliant/examples/examples.hpp"
#include "pliant/generate/random_graphs.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace ring_sweeps_test {

class RingsAlone : public testing::TestWithParam<const char*> {};

/// A ring of six at 0 to 5, a bridge 5 - 6, and a ring of five at 6 to 10.
Sketch two_rings() {
  Sketch sketch = ring(6);
  const Sketch second = ring(5);
  const Vec3 aside{10, 1, 2};
  for (Vec3 p : second.positions) sketch.positions.push_back(p + aside);
  for (Bar bar : second.bars) sketch.bars.push_back({bar.a + 6, bar.b + 6});
  sketch.bars.push_back({5, 6});
  return sketch;
}

ResolveSummary resolved(const char* technique, const Framework& framework, std::vector<Vec3>& x,
                        Joint root = 0) {
  ResolveOptions options;
  options.tolerance.relative = 1e-10;
  return resolve(framework, {technique}, x, options, root);
}

TEST_P(RingsAlone, ATreeTakesOneSweepAndThePushedJointStays) {
  const Framework framework = framework_of(star(7));
  std::vector<Vec3> x = star(7).positions;
  x[3] += Vec3{0.3, 0.4, -0.2};
  const Vec3 pushed = x[3];
  const ResolveSummary summary = resolved(GetParam(), framework, x, 3);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.sweeps, 1);
  EXPECT_EQ(summary.projections, 7);
  EXPECT_EQ(x[3], pushed);
}

/// Only the ring that was broken is swept; the other is carried, neither turned nor bent.
TEST_P(RingsAlone, AWholeRingIsCarriedAsItIs) {
  const Sketch sketch = two_rings();
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = sketch.positions;
  x[5] += Vec3{0.0, 0.2, 0.3};
  const Vec3 pushed = x[5];
  const ResolveSummary summary = resolved(GetParam(), framework, x, 5);
  ASSERT_TRUE(summary.converged());
  EXPECT_GT(summary.sweeps, 1);
  EXPECT_EQ(summary.projections, 6 * summary.sweeps + 1);
  EXPECT_EQ(x[5], pushed);
  const Vec3 by = x[6] - sketch.positions[6];
  EXPECT_GT(norm(by), 1e-3);
  for (std::size_t i = 7; i < 11; ++i) EXPECT_LT(distance(x[i], sketch.positions[i] + by), 1e-14);
}

/// Rings that share a joint are swept apart from each other and meet there again.
TEST_P(RingsAlone, RingsThatShareAJointMeetAgain) {
  Sketch sketch = ring(4);
  const Vec3 aside = sketch.positions[2] - sketch.positions[0];
  for (Joint i = 1; i < 4; ++i) sketch.positions.push_back(sketch.positions[i] + aside);
  sketch.bars.insert(sketch.bars.end(), {{2, 4}, {4, 5}, {5, 6}, {6, 2}});
  const Framework framework = framework_of(sketch);
  for (Joint root : {0u, 2u, 5u}) {
    std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.2);
    EXPECT_TRUE(resolved(GetParam(), framework, x, root).converged());
  }
}

TEST_P(RingsAlone, APinnedJointIsWhereThePassBegins) {
  const Sketch sketch = two_rings();
  const Framework framework = test::with_pinned(framework_of(sketch), {8});
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1);
  EXPECT_TRUE(resolved(GetParam(), framework, x, 1).converged());
  EXPECT_EQ(x[8], sketch.positions[8]);
}

/// Nothing hangs free between two pinned joints.
TEST_P(RingsAlone, BetweenPinnedJointsEveryBarIsSwept) {
  const Sketch sketch = two_rings();
  const Framework framework = test::with_pinned(framework_of(sketch), {2, 8});
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1);
  const ResolveSummary summary = resolved(GetParam(), framework, x, 1);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.projections, 12 * summary.sweeps);
  EXPECT_EQ(x[2], sketch.positions[2]);
  EXPECT_EQ(x[8], sketch.positions[8]);
}

TEST_P(RingsAlone, ACallerWhoStopsItGetsThePiecesPutTogether) {
  const Sketch sketch = two_rings();
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.3);
  ResolveOptions options;
  options.tolerance.relative = 1e-12;
  options.should_stop = [] { return true; };
  EXPECT_EQ(resolve(framework, {GetParam()}, x, options).stop, Stop::stopped_by_caller);
  EXPECT_LT(std::abs(distance(x[5], x[6]) - framework.rest_lengths().back()), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Techniques, RingsAlone, testing::Values("rings_first", "rings_anderson"),
                         [](const auto& row) { return std::string(row.param); });

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

/// The promise of SweepGroup: what P plain sweeps resolve takes at most 3 P + 50.
TEST(Anderson, IsNeverWorseThanPlainByMoreThanItsPromise) {
  each_pushed_graph([](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    for (double weighting : {0.5, 1.0}) {
      const auto plain = resolved_within({"bfs_cycle", weighting}, framework, x, root);
      const auto fast = resolved_within({"anderson", weighting}, framework, x, root);
      EXPECT_GE(fast.converged(), plain.converged());
      EXPECT_LE(fast.sweeps, 3 * plain.sweeps + 50) << weighting;
    }
    const auto plain = resolved_within({"rings_first"}, framework, x, root);
    const auto fast = resolved_within({"rings_anderson"}, framework, x, root);
    EXPECT_LE(fast.sweeps, 3 * plain.sweeps + 50);
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

/// The thesis' most consistent technique against sweeping rings alone, bar for bar.
TEST(RingsFirst, NeedsLessWorkThanEverySweepOfAllBars) {
  std::int64_t rings = 0, fast = 0, of_thesis = 0;
  each_pushed_graph([&](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    rings += resolved_within({"rings_first"}, framework, x, root).projections;
    fast += resolved_within({"rings_anderson"}, framework, x, root).projections;
    of_thesis += resolved_within({"bfs_cycle", 0.5}, framework, x, root).projections;
  });
  EXPECT_LT(2 * rings, of_thesis);
  EXPECT_LT(3 * fast, 2 * rings);
}

}  // namespace ring_sweeps_test
}  // namespace pliant
