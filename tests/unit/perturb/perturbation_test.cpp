// SPDX-License-Identifier: MIT
#include "pliant/perturb/perturbation.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/past.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant {

void PrintTo(const PerturbationEntry& row, std::ostream* out) { *out << row.name; }

namespace perturbation_test {

/// One step of a pusher that acts alone.
Push push_by(const PusherEntry& row, const Framework& framework, const PerturbOptions& options,
             const RandomKey& key, State& state) {
  Past past;
  past.begin_step(state);
  Push push;
  row.make(framework, {options})
      ->push({framework, key, options.timestep, options.damping, past.older()}, state, push);
  return push;
}

/// What each row of the table promises.
class PerturbationLaw : public testing::TestWithParam<PerturbationEntry> {
 protected:
  static Push push(const Framework& framework, State& state, std::uint64_t step,
                   const PerturbOptions& options = {}) {
    return push_by(GetParam(), framework, options, {.seed = 9, .step = step}, state);
  }
};

TEST_P(PerturbationLaw, RemembersWhereAllJointsWere) {
  const Framework framework = test::with_masses(framework_of(chain(6)));
  State state(chain(6).positions);
  for (std::uint64_t step = 1; step < 5; ++step) {
    const std::vector<Vec3> before = state.positions;
    const Push pushed = push(framework, state, step);
    EXPECT_TRUE(test::same_bits(state.previous, before));
    EXPECT_FALSE(test::same_bits(state.positions, before));
    EXPECT_GE(pushed.root_joint, 0);
    EXPECT_LT(pushed.root_joint, 6);
    EXPECT_TRUE(is_finite(pushed.force));
  }
}

TEST_P(PerturbationLaw, LeavesPinnedJoints) {
  const Framework framework = test::with_pinned(framework_of(chain(6)), {0, 3});
  State state(chain(6).positions);
  const std::vector<Vec3> start = state.positions;
  for (std::uint64_t step = 0; step < 50; ++step) push(framework, state, step);
  EXPECT_EQ(state.positions[0], start[0]);
  EXPECT_EQ(state.positions[3], start[3]);
  EXPECT_NE(state.positions[1], start[1]);
}

TEST_P(PerturbationLaw, LeavesZInAPlanarFramework) {
  const Sketch sketch = chain(6);
  const Framework framework({.joint_count = 6,
                             .bars = sketch.bars,
                             .rest_lengths = drawn_lengths(sketch),
                             .planar = true});
  State state(sketch.positions);
  state.previous[2].z = 0.5;
  for (std::uint64_t step = 0; step < 50; ++step) {
    push(framework, state, step);
    for (const Vec3& x : state.positions) ASSERT_EQ(x.z, 0.0);
  }
  EXPECT_NE(state.positions[1], sketch.positions[1]);
}

TEST_P(PerturbationLaw, TakesAFrameworkOfPinnedJointsAndOfNone) {
  const Framework framework = test::with_pinned(framework_of(chain(3)), {0, 1, 2});
  State state(chain(3).positions), nothing;
  push(framework, state, 0);
  EXPECT_EQ(state.positions, chain(3).positions);
  EXPECT_EQ(push(Framework({}), nothing, 0).root_joint, no_joint);
}

/// The push is a function of seed, walker and step, not of what was pushed before.
TEST_P(PerturbationLaw, DependsOnItsKeyAlone) {
  const Framework framework = framework_of(chain(6));
  const PerturbOptions options;
  std::set<std::uint64_t> hashes;
  for (const RandomKey& key :
       {RandomKey{.seed = 1}, {.seed = 2}, {.seed = 1, .walker = 1}, {.seed = 1, .step = 1}}) {
    State first(chain(6).positions), second(chain(6).positions), other(chain(6).positions);
    push_by(GetParam(), framework, options, key, first);
    push(framework, other, 77);
    push_by(GetParam(), framework, options, key, second);
    EXPECT_TRUE(test::same_bits(first.positions, second.positions));
    hashes.insert(test::hash_of(first.positions));
  }
  EXPECT_EQ(hashes.size(), 4u);
}

INSTANTIATE_TEST_SUITE_P(Table, PerturbationLaw,
                         testing::ValuesIn(perturbations().begin(), perturbations().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Perturbations, AreFoundByName) {
  for (const PerturbationEntry& row : perturbations())
    EXPECT_EQ(&find_perturbation(row.name), &row);
  EXPECT_ERROR(
      OptionError,
      "no perturbation named \"forces\" (did you mean \"force\"?); known: force, force_all, "
      "displacement",
      find_perturbation("forces"));
}

/// One joint at rest: x + 100 F / m dt^2.
TEST(Force, PushesOneJointByVerlet) {
  const Framework framework = test::with_masses(framework_of(chain(5)));
  const PerturbOptions options{.force = 30.0, .timestep = 0.02};
  std::set<std::int64_t> pushed;
  for (std::uint64_t step = 0; step < 100; ++step) {
    State state(chain(5).positions);
    const Push push =
        push_by(find_perturbation("force"), framework, options, {.step = step}, state);
    const auto root = static_cast<std::size_t>(push.root_joint);
    EXPECT_NEAR(norm(push.force), 30.0, 1e-13);
    const Vec3 expected = chain(5).positions[root] +
                          (100.0 * framework.inverse_masses()[root] * 0.02 * 0.02) * push.force;
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_LT(distance(state.positions[i], i == root ? expected : chain(5).positions[i]), 1e-14);
    pushed.insert(push.root_joint);
  }
  EXPECT_EQ(pushed.size(), 5u) << "each joint has its turn";
}

TEST(Force, ChoosesFreeJointsEvenly) {
  const Framework framework = test::with_pinned(framework_of(chain(5)), {1, 2});
  int hits[5] = {};
  for (std::uint64_t step = 0; step < 3000; ++step) {
    State state(chain(5).positions);
    ++hits[push_by(find_perturbation("force"), framework, {}, {.step = step}, state).root_joint];
  }
  EXPECT_EQ(hits[1] + hits[2], 0);
  for (int joint : {0, 3, 4}) EXPECT_NEAR(hits[joint], 1000, 130);
}

TEST(Displacement, MovesEachJointByOneLength) {
  const Framework framework = framework_of(chain(5));
  State state(chain(5).positions);
  const PerturbOptions options{.displacement = 0.25};
  push_by(find_perturbation("displacement"), framework, options, {}, state);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(distance(state.positions[i], chain(5).positions[i]), 0.25, 1e-15);
}

/// A free joint under a constant force: Verlet's recursion is exact for a parabola,
/// x_k = a dt^2 k (k + 1) / 2 from rest.
TEST(ApplyForces, FollowsTheParabolaOfAConstantForce) {
  const Framework framework({.joint_count = 1, .masses = {4}});
  const PerturbOptions options{.timestep = 0.125};
  State state(std::vector<Vec3>(1));
  const JointForce force{0, {2, 0, -1}};
  for (int k = 1; k <= 20; ++k) {
    apply_forces(framework, options, {&force, 1}, state);
    const double distance_gone = 100.0 / 4.0 * 0.125 * 0.125 * k * (k + 1) / 2.0;
    EXPECT_NEAR(state.positions[0].x, 2.0 * distance_gone, 1e-11);
    EXPECT_NEAR(state.positions[0].z, -1.0 * distance_gone, 1e-11);
  }
}

/// Damping c: each step keeps 1 - c of the last move.
TEST(ApplyForces, DampsTheVelocity) {
  const Framework framework = [] { return Framework({.joint_count = 1}); }();
  const JointForce no_force{0, {}};
  for (double damping : {0.0, 0.25, 1.0}) {
    State state({{1, 0, 0}});
    state.previous = {{0, 0, 0}};
    apply_forces(framework, {.damping = damping}, {&no_force, 1}, state);
    EXPECT_EQ(state.positions[0].x, 2.0 - damping);
  }
}

TEST(ApplyForces, WithoutForcesMovesNothing) {
  const Framework framework = framework_of(chain(2));
  State state(chain(2).positions);
  const Push push = apply_forces(framework, {}, {}, state);
  EXPECT_EQ(push.root_joint, no_joint);
  EXPECT_EQ(push.force, (Vec3{}));
  EXPECT_EQ(state.positions, chain(2).positions);
}

TEST(CheckPerturbOptions, NamesOptionValueAndRange) {
  EXPECT_NO_THROW(check(PerturbOptions{}));
  const std::pair<const char*, PerturbOptions> cases[] = {
      {"force = -1: must be 0 or more and finite", {.force = -1}},
      {"force = inf: must be 0 or more and finite", {.force = HUGE_VAL}},
      {"timestep = 0: must be positive and finite", {.timestep = 0}},
      {"timestep = nan: must be positive and finite", {.timestep = std::nan("")}},
      {"damping = 1.5: must be from 0 to 1", {.damping = 1.5}},
      {"damping = -1e-09: must be from 0 to 1", {.damping = -1e-9}},
      {"displacement = -0.1: must be 0 or more and finite", {.displacement = -0.1}}};
  for (const auto& [text, options] : cases) EXPECT_ERROR(OptionError, text, check(options));
}

/// ForceGen: what a run meets, so that a force file replays it.
TEST(RandomPushes, AreThoseOfThePerturbationForce) {
  const Framework framework = test::with_pinned(framework_of(chain(6)), {0, 3});
  const RandomKey key{.seed = 9, .walker = 4, .step = 10};
  const PerturbOptions options{.force = 7.0};
  const std::vector<JointForce> pushes = random_pushes(framework, options, key, 20);
  ASSERT_EQ(pushes.size(), 20u);
  State state(chain(6).positions);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Push push = push_by(find_perturbation("force"), framework, options,
                              {.seed = 9, .walker = 4, .step = 11 + k}, state);
    EXPECT_EQ(push.root_joint, pushes[k].joint);
    EXPECT_EQ(push.force, pushes[k].force);
    EXPECT_NEAR(norm(pushes[k].force), 7.0, 1e-12);
  }
}

TEST(RandomPushes, NeedAFreeJoint) {
  const Framework framework = test::with_pinned(framework_of(chain(2)), {0, 1});
  EXPECT_ERROR(OptionError, "no joint is free to be pushed: all are pinned",
               random_pushes(framework, {}, {}, 1));
  EXPECT_TRUE(random_pushes(framework, {}, {}, 0).empty());
}

}  // namespace perturbation_test
}  // namespace pliant
