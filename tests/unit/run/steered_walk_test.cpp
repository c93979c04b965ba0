// SPDX-License-Identifier: MIT
#include "pliant/run/steered_walk.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/held_pull.hpp"
#include "pliant/run/taut_chain.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::steered_walk_test {

RunOptions by(const char* technique) { return {.technique = {.name = technique}}; }

const std::vector<JointForce> push{{2, {40.0, 30.0, 20.0}}, {5, {-10.0, 0.0, 7.0}}};

TEST(SteeredWalk, PullsAsAMotionWithSteeringDoes) {
  const Framework framework = framework_of(ring(9));
  MotionOptions alone{.technique = {.name = "bfs_cycle"}};
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
  EXPECT_ERROR(OptionError, "on_bar: technique newton does not go bar by bar; orderings do",
               walk.set(by("newton")));
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
  EXPECT_ERROR(OptionError,
               "technique = bfs_tree: is for trees only, but the framework has 1 independent cycle",
               walk.set(by("bfs_tree")));
  EXPECT_ERROR(InputError, "pinned joint 9 of 9 does not exist", walk.pin(std::vector<Joint>{9}));
  const std::vector<JointForce> nowhere{{9, {}}};
  EXPECT_ERROR(OptionError, "steering: joint 9 of 9 does not exist", walk.pull(nowhere));
  EXPECT_EQ(walk.options().technique.name, "bfs_cycle");
  EXPECT_TRUE(walk.pinned().empty());
  EXPECT_EQ(walk.state().step, 0);
  EXPECT_EQ(walk.pull(push).stop, Stop::converged);
}

/// A chain of ten whose end is tied to its third joint by a limit that is nearly reached.
Framework tied(std::vector<Joint> pinned = {}) {
  FrameworkParts parts = framework_of(chain(10)).parts();
  const std::vector<Vec3> x = chain(10).positions;
  parts.limits = {{2, 9, 0.0, distance(x[2], x[9]) + 0.01, LimitKind::hydrogen_bond, 0.0, 4}};
  parts.pinned = std::move(pinned);
  return Framework(parts);
}

const HandPull away{9, {30.0, 30.0, 0.0}};

/// Steps of the hand. Returns how far the joint got along the pull at best.
double pull(SteeredWalk& walk, const HandPull& hand, int steps) {
  const Vec3 start = walk.state().positions[hand.joint], way = hand.target - start;
  double best = 0.0;
  for (int k = 0; k < steps; ++k) {
    const JointForce force =
        force_of(hand, walk.framework(), walk.state(), walk.options().perturb_options);
    walk.pull({&force, 1});
    best = std::max(best, dot(way, walk.state().positions[hand.joint] - start) / norm(way));
  }
  return best;
}

TEST(HandPull, MovesAJointAShareOfTheWay) {
  const Framework framework({.joint_count = 1, .masses = {12.0}});
  State state({{1.0, 2.0, 3.0}});
  state.previous[0] = {0.8, 2.0, 3.0};
  SteeredWalk walk(framework, state);
  pull(walk, {0, {2.0, 2.0, 3.0}, 0.5, 10.0}, 1);
  EXPECT_NEAR(walk.state().positions[0].x, 1.5, 1e-12);
  pull(walk, {0, {9.0, 2.0, 3.0}, 0.5, 0.25}, 1);
  EXPECT_NEAR(walk.state().positions[0].x, 1.75, 1e-12);
}

TEST(WhyHeld, NamesAContactThatFreesWhenItIsCut) {
  const Framework framework = tied({2});
  SteeredWalk walk(framework, State(chain(10).positions));
  walk.start();
  pull(walk, away, 10);
  const std::vector<Vec3> before = walk.state().positions;
  const HeldPull found = why_held(walk, away);
  EXPECT_TRUE(test::same_bits(before, walk.state().positions)) << "asking moves nothing";
  ASSERT_EQ(found.holders.size(), 2u);
  const Holder& contact = found.holders[found.holders[0].kind == Holder::Kind::pin ? 1 : 0];
  EXPECT_EQ(contact.kind, Holder::Kind::limit);
  EXPECT_EQ(contact.limit, 0u);
  EXPECT_TRUE(found.frees()) << found.as_it_is << " " << found.without;
  const double held = pull(*walk.branch(), away, HeldOptions().steps);
  walk.edit(cuts_of(found.holders));
  const double free = pull(walk, away, HeldOptions().steps);
  EXPECT_NEAR(held, found.as_it_is, 1e-9);
  EXPECT_NEAR(free, found.without, 1e-9);
  EXPECT_GT(free, held);
}

TEST(WhyHeld, NamesPins) {
  const Framework framework = framework_of(straight_chain(8));
  SteeredWalk walk(framework, State(straight_chain(8).positions));
  walk.pin(std::vector<Joint>{1});
  walk.start();
  const HandPull hand{7, {30.0, 0.0, 0.0}};
  const HeldPull found = why_held(walk, hand);
  ASSERT_EQ(found.holders.size(), 1u);
  EXPECT_EQ(found.holders[0].kind, Holder::Kind::pin);
  EXPECT_EQ(found.holders[0].a, 1u);
  EXPECT_NEAR(found.holders[0].load, 1.0, 0.02);
  EXPECT_TRUE(found.frees());
  ASSERT_TRUE(found.taut);
  EXPECT_EQ(found.taut->joints.back(), 0u) << "the chain is straight to its very end";
  walk.pin(std::vector<Joint>{7});
  EXPECT_TRUE(why_held(walk, hand).is_pinned);
}

TEST(WhyHeld, NamesNothingWhereAJointIsFree) {
  const Framework framework = framework_of(chain(10));
  SteeredWalk walk(framework, State(chain(10).positions));
  walk.start();
  const HeldPull found = why_held(walk, {9, {0.0, 0.0, 9.0}});
  EXPECT_TRUE(found.holders.empty());
  EXPECT_FALSE(found.taut);
  EXPECT_GT(found.yields, 0.85);
}

TEST(TautChain, IsAllTransWithItsAngles) {
  const Sketch zigzag = with_angles(chain(10));
  const Framework framework = framework_of(zigzag);
  const auto found = find_taut_chain(framework, zigzag.positions, 9, {0.7, 0.7, 0.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->joints.size(), 10u);
  EXPECT_NEAR(found->reach, 1.0, 1e-9);
  EXPECT_FALSE(find_taut_chain(framework, zigzag.positions, 9, {-0.7, -0.7, 0.0}));
  EXPECT_FALSE(find_taut_chain(framework_of(chain(10)), chain(10).positions, 9, {0.7, 0.7, 0.0}))
      << "without angles the staircase can be drawn straight";
}

}  // namespace pliant::steered_walk_test
