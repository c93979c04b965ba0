// SPDX-License-Identifier: MIT
// Claim T1 of the thesis: a tree resolved breadth or depth first with weighting 1 takes exactly one
// sweep. It holds for every tree, root and break: each bar is projected after the bar that moves
// its near joint, and only its far joint moves.
#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::tree_law_test {

/// A random tree: each joint hangs on one of the `reach` joints before it, so that a reach of 1 is
/// a path, and a large one a bush; of a forest one in sixteen begins a tree of its own. Bars are in
/// a random order, with random first ends.
Sketch random_tree(std::size_t count, std::size_t reach, RandomSequence& draws,
                   bool is_forest = false) {
  Sketch sketch;
  for (std::size_t i = 0; i < count; ++i) {
    sketch.positions.push_back(10.0 * draws.uniform() * draws.direction());
    if (i == 0 || (is_forest && draws.below(16) == 0)) continue;
    const std::size_t first = i > reach ? i - reach : 0;
    const auto here = static_cast<Joint>(i);
    const auto there = static_cast<Joint>(first + draws.below(i - first));
    sketch.bars.push_back(draws.below(2) == 0 ? Bar{here, there} : Bar{there, here});
  }
  for (std::size_t left = sketch.bars.size(); left > 1; --left)
    std::swap(sketch.bars[left - 1], sketch.bars[draws.below(left)]);
  return sketch;
}

constexpr std::size_t most_joints = 10000;

/// From 2 to 10^4, most of them small; the first three trees are the largest: a path, a bush, and
/// between them.
std::size_t random_size(std::uint64_t number, RandomSequence& draws) {
  if (number < 3) return most_joints;
  const double u = draws.uniform();
  return static_cast<std::size_t>(2.0 * std::pow(most_joints / 2.0, std::pow(u, 10)));
}

/// A force in any direction that moves its joint by 0.1 to 10^4 Angstrom in one step.
JointForce random_push(Joint joint, const PerturbOptions& options, RandomSequence& draws) {
  const double displacement = std::pow(10.0, -1.0 + 5.0 * draws.uniform());
  const double force = displacement / (100.0 * options.timestep * options.timestep);
  return {joint, force * draws.direction()};
}

class TreeLaw : public testing::TestWithParam<const char*> {};

/// Claim T1 as the thesis has it: mean 1, mode 1, standard deviation 0 over all trees and forces. A
/// push that happens to leave all bars whole takes 0 and does not count.
TEST_P(TreeLaw, AnyTreeAnyForceExactlyOneSweep) {
  constexpr std::uint64_t trees = 10000;
  constexpr std::size_t reaches[] = {1, most_joints, 8};
  const PerturbOptions push{.damping = 1.0};
  std::size_t largest = 0;
  std::int64_t sweeps = 0, squares = 0, steps = 0;
  for (std::uint64_t number = 0; number < trees; ++number) {
    RandomSequence draws({.seed = 1, .domain = Domain::generate, .step = number});
    const std::size_t count = random_size(number, draws);
    largest = std::max(largest, count);
    const Sketch sketch = random_tree(count, reaches[number % 3], draws);
    const Framework framework = framework_of(sketch);
    State state(sketch.positions);
    for (int step = 0; step < 2; ++step) {
      const JointForce force = random_push(static_cast<Joint>(draws.below(count)), push, draws);
      apply_forces(framework, push, {&force, 1}, state);
      const bool broken = !measure(framework, state.positions).within;
      const ResolveSummary summary =
          resolve(framework, {GetParam(), 1.0}, state.positions, {}, force.joint);
      ASSERT_TRUE(summary.converged()) << "tree " << number << summary.brief(framework);
      ASSERT_EQ(summary.sweeps, broken ? 1 : 0) << "tree " << number;
      steps += broken;
      sweeps += summary.sweeps;
      squares += summary.sweeps * summary.sweeps;
    }
  }
  EXPECT_EQ(largest, most_joints);
  EXPECT_GE(steps, 2 * std::int64_t(trees) - 10);
  EXPECT_EQ(sweeps, steps) << "the mean is 1";
  EXPECT_EQ(squares, steps) << "the standard deviation is 0";
}

TEST_P(TreeLaw, AnyForestAnyBreakExactlyOneSweep) {
  constexpr double sizes[] = {1e-3, 0.1, 3.0};
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; tried < 10000; ++seed) {
    RandomSequence draws({seed, Domain::generate});
    const std::size_t count = 2 + draws.below(30);
    const Sketch sketch = random_tree(count, count, draws, true);
    if (sketch.bars.empty()) continue;
    ++tried;
    const Framework framework = framework_of(sketch);
    ASSERT_TRUE(graph_facts(framework).is_forest());
    std::vector<Vec3> x = test::shake(framework, sketch.positions, sizes[seed % 3], seed);
    const ResolveOptions options{.tolerance = {.relative = 1e-11}};
    const auto root = static_cast<Joint>(seed % sketch.positions.size());
    const Vec3 root_before = x[root];
    const ResolveSummary summary = resolve(framework, {GetParam(), 1.0}, x, options, root);
    ASSERT_EQ(summary.stop, Stop::converged) << "seed " << seed << summary.brief(framework);
    ASSERT_EQ(summary.sweeps, 1) << "seed " << seed;
    ASSERT_EQ(summary.projections, std::int64_t(sketch.bars.size()));
    ASSERT_EQ(x[root], root_before) << "the pushed joint stays where it was pushed to";
  }
}

/// The push of the thesis: only the root is moved.
TEST_P(TreeLaw, APushedRootTakesOneSweepOnEveryTree) {
  for (const Example& example : examples()) {
    if (example.facts.cycles > 0 || !example.facts.whole || example.framework.bar_count() == 0)
      continue;
    if (!example.framework.has_bars_only()) continue;  // limits take sweeps of their own
    SCOPED_TRACE(example.name);
    for (Joint root = 0; root < example.framework.joint_count(); ++root) {
      if (example.framework.neighbours(root).empty()) continue;
      std::vector<Vec3> x = example.positions;
      x[root] += Vec3{0.2, -0.1, 0.3};
      const ResolveSummary summary = resolve(example.framework, {GetParam(), 1.0}, x, {}, root);
      EXPECT_TRUE(summary.converged());
      EXPECT_EQ(summary.sweeps, 1);
    }
  }
}

TEST_P(TreeLaw, CyclesAreRefusedByTheTreeOrderings) {
  if (!find_ordering(GetParam()).forests_only) GTEST_SKIP();
  std::vector<Vec3> x = ring(4).positions;
  EXPECT_ERROR(OptionError,
               "technique = " + std::string(GetParam()) +
                   ": is for trees only, but the framework has 1 independent cycle",
               resolve(framework_of(ring(4)), {GetParam(), 1.0}, x));
}

// The _cycle orderings are the _tree ones where there is no cycle.
INSTANTIATE_TEST_SUITE_P(Orderings, TreeLaw,
                         testing::Values("bfs_tree", "dfs_tree", "bfs_cycle", "dfs_cycle"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace pliant::tree_law_test
