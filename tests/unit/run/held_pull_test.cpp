// SPDX-License-Identifier: MIT
#include "pliant/run/held_pull.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/taut_chain.hpp"
#include "support/frameworks.hpp"

namespace pliant::held_pull_test {

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

}  // namespace pliant::held_pull_test
