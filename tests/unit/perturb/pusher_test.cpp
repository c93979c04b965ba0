// SPDX-License-Identifier: MIT
#include "pliant/perturb/pusher.hpp"

#include <thread>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/perturb/push_chain.hpp"
#include "pliant/perturb/pushers.hpp"
#include "pliant/perturb/steering.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::pusher_test {

constexpr RandomKey seed_5{.seed = 5};

std::shared_ptr<Pusher> made(std::string_view name, const Framework& framework,
                             const PusherOptions& options = {}) {
  return find_pusher(name).make(framework, options);
}

/// What a chain of these pushers does to a state in a step.
State pushed_by(const std::vector<std::string_view>& names, const Framework& framework,
                State state) {
  PushChain chain(framework, {}, seed_5);
  for (std::string_view name : names) chain.add(made(name, framework));
  chain.push(state);
  return state;
}

TEST(Pushers, AreThePerturbationsAReplayAndGuides) {
  EXPECT_EQ(pushers().size(), perturbations().size() + 4);
  EXPECT_EQ(pushers()[perturbations().size()].name, "replay");
  EXPECT_ERROR(
      OptionError,
      "no pusher named \"tug\"; known: force, force_all, displacement, replay, rock, pull, "
      "pair_distance",
      find_pusher("tug"));
}

TEST(PushChain, MergesWhomTheyMoved) {
  const Framework framework = framework_of(chain(6));
  State state(chain(6).positions);
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(made("replay", framework, {{}, {{4, {1, 0, 0}}, {4, {1, 0, 0}}}}));
  const auto steering = std::make_shared<Steering>();
  chain_of.add(steering);
  chain_of.push(state);
  EXPECT_EQ(chain_of.pushed().joints, (std::vector<Joint>{4}));
  const JointForce pulls[] = {{2, {0, 1, 0}}, {4, {0, 1, 0}}};
  steering->pull(pulls);
  chain_of.push(state);
  const Push& push = chain_of.pushed();
  EXPECT_EQ(push.root_joint, 4) << "of the first that acts";
  EXPECT_EQ(push.force, (Vec3{1, 0, 0}));
  EXPECT_EQ(push.joints, (std::vector<Joint>{2, 4})) << "each once";
  EXPECT_FALSE(push.disturbed().all);
  chain_of.add(made("displacement", framework));
  chain_of.push(state);
  EXPECT_TRUE(chain_of.pushed().disturbed().all);
  EXPECT_EQ(chain_of.pushed().root_joint, 2);
}

TEST(PushChain, LeavesWhereJointsWereBeforeTheStep) {
  const Framework framework = framework_of(chain(6));
  State state(chain(6).positions);
  PushChain chain_of(framework, {}, seed_5);
  for (const char* name : {"force", "displacement", "force_all", "force"})
    chain_of.add(made(name, framework));
  for (int step = 0; step < 4; ++step) {
    const std::vector<Vec3> before = state.positions;
    chain_of.push(state);
    EXPECT_TRUE(test::same_bits(state.previous, before));
  }
  EXPECT_EQ(state.step, 4);
  EXPECT_DOUBLE_EQ(state.time, 0.04);
}

/// A joint's velocity carries it once, and forces add up.
TEST(PushChain, TwoForcesOnAJointAreTheirSum) {
  const Framework framework = test::with_masses(framework_of(chain(3)));
  State two(chain(3).positions);
  two.previous[1] += Vec3{0.01, 0.02, 0};
  State one = two;
  PushChain both(framework, {}, seed_5), sum(framework, {}, seed_5);
  both.add(made("replay", framework, {{}, {{1, {3, 0, 1}}}}));
  both.add(made("replay", framework, {{}, {{1, {1, 2, 0}}}}));
  sum.add(made("replay", framework, {{}, {{1, {4, 2, 1}}}}));
  both.push(two);
  sum.push(one);
  EXPECT_LT(distance(one.positions[1], two.positions[1]), 1e-15);
  EXPECT_NE(one.positions[1], one.previous[1]);
}

TEST(PushChain, EachPusherDrawsForItself) {
  const Framework framework = framework_of(chain(6));
  const State start(chain(6).positions);
  const State alone = pushed_by({"displacement"}, framework, start);
  const State both = pushed_by({"displacement", "displacement"}, framework, start);
  for (Joint joint = 0; joint < 6; ++joint) {
    const Vec3 first = alone.positions[joint] - start.positions[joint];
    EXPECT_GT(distance(both.positions[joint] - alone.positions[joint], first), 1e-3);
  }
}

TEST(PushChain, IsOverWhenAllHavePushedForTheLastTime) {
  const Framework framework = framework_of(chain(3));
  State state(chain(3).positions);
  PushChain chain_of(framework, {}, seed_5);
  chain_of.push(state);
  EXPECT_FALSE(chain_of.is_over()) << "nobody pushes";
  PusherOptions options{{}, {{0, {}}, {1, {}}}, 1};
  chain_of.add(made("replay", framework, options));
  chain_of.push(state);
  EXPECT_FALSE(chain_of.is_over());
  EXPECT_EQ(chain_of.pushed().root_joint, 0);
  chain_of.push(state);
  EXPECT_TRUE(chain_of.is_over());
  chain_of.push(state);
  EXPECT_EQ(chain_of.pushed().root_joint, no_joint) << "no force is left";
}

class Failing final : public Pusher {
  bool push(const PushCall&, State& state, Push&) override {
    state.positions[0].x += 1.0;
    throw InputError("no more");
  }
};

TEST(PushChain, APusherThatThrowsLeavesTheStateAsItWas) {
  const Framework framework = framework_of(chain(3));
  State state(chain(3).positions);
  state.previous[2].x += 0.5;
  const State before = state;
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(made("force_all", framework));
  chain_of.add(std::make_shared<Failing>());
  EXPECT_THROW(chain_of.push(state), InputError);
  EXPECT_TRUE(test::same_bits(state.positions, before.positions));
  EXPECT_TRUE(test::same_bits(state.previous, before.previous));
  EXPECT_EQ(state.step, 0);
}

TEST(Replay, RefusesForcesAndCountsThatCannotBe) {
  const std::vector<JointForce> two{{0, {}}, {1, {}}};
  const std::pair<const char*, PusherOptions> cases[] = {
      {"replay: joint 3 of 3 does not exist", {.replay = {{3, {}}}}},
      {"replay: the force on joint 1 is not finite", {.replay = {{1, {0, std::nan(""), 0}}}}},
      {"replay: a step has 2 forces, where 1 are left", {.replay = two, .replay_counts = {1, 2}}},
      {"replay: a step has -1 forces, where 2 are left", {.replay = two, .replay_counts = {-1}}},
      {"replay: 1 forces belong to no step", {.replay = two, .replay_counts = {1}}}};
  for (const auto& [text, options] : cases)
    EXPECT_ERROR(OptionError, text, made("replay", framework_of(chain(3)), options));
}

TEST(Steering, PullsUntilReleasedAsApplyForcesDoes) {
  const Framework framework = test::with_masses(framework_of(chain(4)));
  State state(chain(4).positions);
  State expected = state;
  const auto steering = std::make_shared<Steering>();
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(steering);
  const JointForce pulls[] = {{1, {0, 2, 0}}, {3, {1, 0, 0}}};
  steering->pull(pulls);
  for (int step = 0; step < 3; ++step) {
    chain_of.push(state);
    apply_forces(framework, {}, pulls, expected);
    EXPECT_TRUE(test::same_bits(state.positions, expected.positions));
  }
  steering->release();
  chain_of.push(state);
  EXPECT_TRUE(test::same_bits(state.positions, state.previous));
  EXPECT_FALSE(chain_of.is_over());
  EXPECT_TRUE(chain_of.pushed().joints.empty());
  EXPECT_FALSE(chain_of.pushed().disturbed().all);
}

TEST(Steering, RefusesWhatCannotBe) {
  const Framework framework = framework_of(chain(3));
  const auto steering = std::make_shared<Steering>();
  EXPECT_ERROR(OptionError, "steering: longest step = 0: must be above 0", Steering(0.0));
  const JointForce endless{0, {HUGE_VAL, 0, 0}}, nowhere{7, {1, 0, 0}};
  EXPECT_ERROR(OptionError, "steering: the force on joint 0 is not finite",
               steering->pull({&endless, 1}));
  steering->pull({&nowhere, 1});
  State state(chain(3).positions);
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(steering);
  EXPECT_ERROR(OptionError, "steering: joint 7 of 3 does not exist", chain_of.push(state));
  EXPECT_EQ(state.step, 0);
}

/// The longest motion in one step of one joint under a force, pulled for some steps.
double longest_motion(Steering& steering, const JointForce& pull, int steps) {
  const Framework framework = test::with_masses(framework_of(chain(4)));
  State state(chain(4).positions);
  steering.pull({&pull, 1});
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(std::shared_ptr<Pusher>(std::shared_ptr<void>(), &steering));
  double longest = 0.0;
  for (int step = 0; step < steps; ++step) {
    chain_of.push(state);
    longest = std::max(longest, distance(state.positions[pull.joint], state.previous[pull.joint]));
  }
  return longest;
}

TEST(Steering, HoldsBackForcesThatMoveTooFar) {
  Steering hand(0.2);
  EXPECT_NEAR(longest_motion(hand, {1, {1e38, -1e38, 1e38}}, 5), 0.2, 1e-12);
  EXPECT_NEAR(longest_motion(hand, {1, {0, 3, 0}}, 500), 0.2, 1e-12) << "by its velocity, too";
  EXPECT_LT(longest_motion(hand, {1, {0, 3, 0}}, 2), 0.2);
  Steering free_hand;
  EXPECT_GT(longest_motion(free_hand, {1, {0, 3, 0}}, 500), 0.2);
}

TEST(Steering, TellsForcesAsTheyActed) {
  const Framework framework = test::with_masses(framework_of(chain(4)));
  State state(chain(4).positions);
  State replayed = state;
  const auto hand = std::make_shared<Steering>(0.05);
  const JointForce pulls[] = {{1, {0, 2000, 0}}, {3, {1, 0, 0}}};
  hand->pull(pulls);
  PushChain by_hand(framework, {}, seed_5), again(framework, {}, seed_5);
  by_hand.add(hand);
  std::vector<JointForce> acted;
  std::vector<std::int64_t> counts;
  std::vector<std::vector<Vec3>> places;
  for (int step = 0; step < 5; ++step) {
    if (step == 3) hand->release();
    by_hand.push(state);
    const auto& forces = by_hand.pushed().forces;
    acted.insert(acted.end(), forces.begin(), forces.end());
    counts.push_back(std::int64_t(forces.size()));
    places.push_back(state.positions);
  }
  EXPECT_EQ(counts, (std::vector<std::int64_t>{2, 2, 2, 0, 0}));
  again.add(find_pusher("replay").make(framework, {.replay = acted, .replay_counts = counts}));
  for (const std::vector<Vec3>& place : places) {
    EXPECT_FALSE(again.is_over());
    again.push(replayed);
    EXPECT_TRUE(test::same_bits(replayed.positions, place));
  }
  EXPECT_TRUE(again.is_over());
}

TEST(Steering, IsAskedFromManyThreads) {
  const Framework framework = framework_of(chain(3));
  State state(chain(3).positions);
  const auto steering = std::make_shared<Steering>();
  PushChain chain_of(framework, {}, seed_5);
  chain_of.add(steering);
  {
    std::vector<std::jthread> threads;
    for (Joint joint = 0; joint < 3; ++joint)
      threads.emplace_back([&steering, joint] {
        for (int k = 0; k < 200; ++k) {
          const JointForce pulls[] = {{joint, {1, 0, 0}}, {joint, {0, 1, 0}}};
          steering->pull(pulls);
        }
      });
    for (int step = 0; step < 200; ++step) {
      chain_of.push(state);
      ASSERT_LE(chain_of.pushed().joints.size(), 1u) << "never half of a pull";
    }
  }
  EXPECT_TRUE(is_finite(state.positions[0]));
}

}  // namespace pliant::pusher_test
