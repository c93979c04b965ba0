// SPDX-License-Identifier: MIT
#include "pliant/run/steered_walk.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace steered_walk_test {

RunOptions by(const char* technique) {
  RunOptions options;
  options.technique.name = technique;
  return options;
}

const std::vector<JointForce> push{{2, {40.0, 30.0, 20.0}}, {5, {-10.0, 0.0, 7.0}}};

TEST(SteeredWalk, PullsAsAMotionWithSteeringDoes) {
  const Framework framework = framework_of(ring(9));
  MotionOptions alone;
  alone.technique.name = "bfs_cycle";
  alone.push.clear();
  Motion motion(framework, State(ring(9).positions), alone);
  const auto steering = std::make_shared<Steering>();
  motion.add(steering);
  steering->pull(push);
  SteeredWalk walk(framework, State(ring(9).positions), by("bfs_cycle"));
  motion.start();
  walk.start();
  for (int k = 0; k < 5; ++k) {
    const Frame a = motion.step(), b = walk.pull(push);
    EXPECT_TRUE(test::same_bits(a.positions, b.positions));
    EXPECT_EQ(a.sweeps, b.sweeps);
    EXPECT_EQ(a.step, b.step);
  }
  EXPECT_EQ(walk.summary().steps, 5);
  EXPECT_EQ(walk.summary().sweeps, motion.summary().sweeps);
}

TEST(SteeredWalk, WandersAsARunDoes) {
  const Framework framework = framework_of(ring(9));
  RunOptions options = by("bfs_cycle");
  options.perturb = "force_all";
  options.resolve.seed = 3;
  options.steps = 4;
  State state(ring(9).positions);
  run(framework, state, options, {});
  SteeredWalk walk(framework, State(ring(9).positions), options);
  walk.start();
  for (int k = 0; k < 4; ++k) walk.wander();
  EXPECT_TRUE(test::same_bits(walk.state().positions, state.positions));
}

/// What was changed and changed back has left no trace.
TEST(SteeredWalk, ChangesOnTheWayChangeNoBits) {
  const Framework framework = framework_of(with_angles(ring(8)));
  SteeredWalk plain(framework, State(with_angles(ring(8)).positions), by("blocks"));
  SteeredWalk busy(framework, State(with_angles(ring(8)).positions), by("blocks"));
  for (int k = 0; k < 4; ++k) {
    busy.set(by("newton"));
    busy.pin(std::vector<Joint>{1});
    busy.set(by("blocks"));
    busy.pin({});
    busy.put(State(busy.state()));
    plain.pull(push);
    busy.pull(push);
    EXPECT_TRUE(test::same_bits(plain.state().positions, busy.state().positions)) << k;
    EXPECT_TRUE(test::same_bits(plain.state().previous, busy.state().previous)) << k;
  }
  EXPECT_EQ(busy.summary().steps, 4);
}

TEST(SteeredWalk, HoldsWhatIsPinned) {
  const Sketch sketch = ring(9);
  const Framework framework = framework_of(sketch);
  SteeredWalk walk(framework, State(sketch.positions), by("bfs_cycle"));
  walk.pin(std::vector<Joint>{1, 2});
  EXPECT_EQ(walk.pull(push).stop, Stop::converged);
  EXPECT_EQ(walk.state().positions[1], sketch.positions[1]);
  EXPECT_EQ(walk.state().positions[2], sketch.positions[2]);
  EXPECT_NE(walk.state().positions[5], sketch.positions[5]);
  walk.pin({});
  walk.pull(push);
  EXPECT_NE(walk.state().positions[2], sketch.positions[2]);
  EXPECT_EQ(framework.pinned_count(), 0u);
}

TEST(SteeredWalk, IsWatchedBarByBar) {
  const Framework framework = framework_of(ring(9));
  SteeredWalk plain(framework, State(ring(9).positions), by("bfs_cycle"));
  SteeredWalk walk(framework, State(ring(9).positions), by("bfs_cycle"));
  std::int64_t visits = 0, looks = 0;
  walk.watch([&](const RepairedBar&) { ++visits; });
  walk.look_at_push([&](std::span<const Vec3> positions) {
    ++looks;
    EXPECT_NE(positions[2], ring(9).positions[2]);
    EXPECT_EQ(positions[3], ring(9).positions[3]);
  });
  plain.pull(push);
  EXPECT_EQ(walk.pull(push).projections, visits);
  EXPECT_EQ(looks, 1);
  EXPECT_TRUE(test::same_bits(plain.state().positions, walk.state().positions));
  EXPECT_EQ(test::error_text<OptionError>([&] { walk.set(by("newton")); }),
            "on_bar: technique newton does not go bar by bar; orderings do");
  walk.watch({});
  walk.set(by("newton"));
}

TEST(SteeredWalk, TellsHowFarAStepWasThatItTookBack) {
  const Framework framework = framework_of(ring(9));
  RunOptions options = by("bfs_cycle");
  int asked = 0;
  bool stops = false;
  options.resolve.should_stop = [&] { return stops && ++asked == 3; };
  SteeredWalk walk(framework, State(ring(9).positions), options);
  walk.start();
  const State before = walk.state();
  stops = true;
  const Frame frame = walk.pull(push);
  EXPECT_EQ(frame.stop, Stop::stopped_by_caller);
  EXPECT_EQ(walk.resolved().sweeps, 3);
  EXPECT_GT(walk.resolved().max_residual, 1e-6);
  EXPECT_LT(walk.resolved().worst_bar, framework.bar_count());
  EXPECT_TRUE(test::same_bits(walk.state().positions, before.positions));
  EXPECT_EQ(walk.state().step, before.step);
}

TEST(SteeredWalk, WhatIsRefusedChangesNothing) {
  const Framework framework = framework_of(ring(9));
  SteeredWalk walk(framework, State(ring(9).positions), by("bfs_cycle"));
  EXPECT_EQ(test::error_text<OptionError>([&] { walk.set(by("bfs_tree")); }),
            "technique = bfs_tree: is for trees only, but the framework has 1 independent cycle");
  EXPECT_EQ(test::error_text<InputError>([&] { walk.pin(std::vector<Joint>{9}); }),
            "pinned joint 9 of 9 does not exist");
  const std::vector<JointForce> nowhere{{9, {}}};
  EXPECT_EQ(test::error_text<OptionError>([&] { walk.pull(nowhere); }),
            "steering: joint 9 of 9 does not exist");
  EXPECT_EQ(walk.options().technique.name, "bfs_cycle");
  EXPECT_TRUE(walk.pinned().empty());
  EXPECT_EQ(walk.state().step, 0);
  EXPECT_EQ(walk.pull(push).stop, Stop::converged);
}

}  // namespace steered_walk_test
}  // namespace pliant
