// SPDX-License-Identifier: MIT
// Laws of resolving what few joints disturbed: after a push where all was whole it does what a
// resolve of all does, to the tolerance, without touching what the push does not reach; and after
// a push of size e no joint ends further from where the push left it than a constant times e,
// however long the framework. The page on methods has the constants.
#include "law/technique_cases.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/test.hpp"

namespace pliant::near_law_test {

class NearLaw : public test::TechniqueLaw {};

bool holds(std::span<const Joint> joints, Joint joint) {
  return std::find(joints.begin(), joints.end(), joint) != joints.end();
}

Vec3 push_of(const Framework& framework) {
  return test::small_break(framework) * RandomSequence({3, Domain::force, 0, 0, 0}).direction();
}

TEST_P(NearLaw, ConvergedMeansEveryBarIsWholeAndTheRestStays) {
  each_case([&](const Example& example, const Technique& technique) {
    if (!example.facts.whole) return;
    const Framework& framework = example.framework;
    Resolver resolver(framework, technique, {{1e-8}, 300});
    for (Joint root = 0; root < std::min<std::size_t>(framework.joint_count(), 4); ++root) {
      std::vector<Vec3> x = example.positions;
      if (!framework.is_pinned(root)) x[root] += push_of(framework);
      const std::vector<Vec3> pushed = x;
      const ResolveSummary summary = resolver.resolve_near(x, root, 5);
      const ResidualSummary all = measure(framework, x, {1e-8});
      EXPECT_EQ(summary.converged(), all.within) << "root " << root;
      ASSERT_TRUE(test::all_finite(x));
      if (!resolver.moved()) continue;
      EXPECT_DOUBLE_EQ(std::max(summary.max_residual, 1e-8), std::max(all.max_relative, 1e-8));
      for (Joint joint = 0; joint < x.size(); ++joint)
        EXPECT_TRUE(x[joint] == pushed[joint] || joint == root || holds(*resolver.moved(), joint))
            << joint;
    }
  });
}

TEST_P(NearLaw, GivesTheSameBitsAgainAndKeepsNothingFromCallToCall) {
  each_example([&](const Example& example) {
    if (!example.facts.whole) return;
    Resolver used(example.framework, plain(), {{1e-8}, 300});
    for (Joint root = 0; root < std::min<std::size_t>(example.framework.joint_count(), 3); ++root) {
      std::vector<Vec3> x = example.positions;
      if (!example.framework.is_pinned(root)) x[root] += push_of(example.framework);
      std::vector<Vec3> y = x;
      used.resolve_near(x, root, 7);
      Resolver(example.framework, plain(), {{1e-8}, 300}).resolve_near(y, root, 7);
      EXPECT_TRUE(test::same_bits(x, y)) << root;
    }
  });
}

/// Some joints that may be pushed, spread over the framework; those of a bar and of a ring too.
std::vector<Joint> some_free_joints(const Framework& framework, std::size_t stride) {
  std::vector<Joint> joints;
  for (std::size_t k = 0; k < framework.joint_count() && joints.size() < 5; k += stride)
    if (!framework.is_pinned(static_cast<Joint>(k))) joints.push_back(static_cast<Joint>(k));
  return joints;
}

std::vector<Vec3> pushed(const Example& example, std::span<const Joint> joints) {
  std::vector<Vec3> x = example.positions;
  for (Joint joint : joints)
    x[joint] += test::small_break(example.framework) *
                RandomSequence({3, Domain::force, 0, 0, joint}).direction();
  return x;
}

TEST_P(NearLaw, SeveralDisturbedJointsLeaveNoBrokenBarUnseen) {
  each_case([&](const Example& example, const Technique& technique) {
    if (!example.facts.whole) return;
    Resolver resolver(example.framework, technique, {{1e-8}, 300});
    for (std::size_t stride : {1, 3, 7}) {
      const std::vector<Joint> joints = some_free_joints(example.framework, stride);
      if (joints.empty()) continue;
      const std::vector<Vec3> before = pushed(example, joints);
      std::vector<Vec3> x = before;
      const ResolveSummary summary = resolver.resolve(x, {joints.back(), false, joints}, 5);
      const ResidualSummary all = measure(example.framework, x, {1e-8});
      EXPECT_EQ(summary.converged(), all.within) << "every " << stride;
      ASSERT_TRUE(test::all_finite(x));
      if (!resolver.moved()) continue;
      EXPECT_DOUBLE_EQ(std::max(summary.max_residual, 1e-8), std::max(all.max_relative, 1e-8));
      for (Joint joint = 0; joint < x.size(); ++joint)
        EXPECT_TRUE(x[joint] == before[joint] || holds(*resolver.moved(), joint)) << joint;
    }
  });
}

TEST_P(NearLaw, OneDisturbedJointIsResolvedAsByResolveNear) {
  each_example([&](const Example& example) {
    std::vector<Joint> joint = some_free_joints(example.framework, 2);
    if (!example.facts.whole || joint.empty()) return;
    joint.resize(1);
    std::vector<Vec3> x = pushed(example, joint), y = x;
    Resolver resolver(example.framework, plain(), {{1e-8}, 300});
    const ResolveSummary a = resolver.resolve(x, {joint[0], false, joint}, 7);
    const ResolveSummary b = resolver.resolve_near(y, joint[0], 7);
    EXPECT_TRUE(test::same_bits(x, y));
    EXPECT_EQ(a.projections, b.projections);
  });
}

PLIANT_FOR_ALL_TECHNIQUES(NearLaw);

TEST(Near, LooksAtNoMoreBarsInALargerFramework) {
  for (const char* name : {"blocks", "auto"}) {
    std::int64_t looked[2];
    for (int k = 0; k < 2; ++k) {
      const Sketch sketch = chain(k == 0 ? 1000 : 100'000);
      const Framework framework = framework_of(sketch);
      std::vector<Vec3> x = sketch.positions;
      x[500] += {0.02, 0.03, -0.05};
      looked[k] = Resolver(framework, {name, 0.5}).resolve_near(x, 500).projections;
    }
    EXPECT_EQ(looked[0], looked[1]) << name;
    EXPECT_LT(looked[0], 2000) << name;
  }
}

/// Pushes far from each other, and two that meet: nothing beyond their reach is touched.
TEST(Near, SeveralPushesCostAsMuchAsEachAlone) {
  const Sketch sketch = shaken(chain(20'000), 0.2);
  const Framework framework = framework_of(sketch);
  const std::vector<Joint> joints = {4000, 12'000, 12'001, 12'004};
  for (const char* name : {"blocks", "auto"}) {
    std::vector<Vec3> x = sketch.positions;
    for (Joint joint : joints) x[joint] += {0.02, 0.03, -0.05};
    Resolver resolver(framework, {name, 0.5});
    const ResolveSummary summary = resolver.resolve(x, {joints[0], false, joints});
    EXPECT_TRUE(summary.converged()) << name;
    EXPECT_LT(summary.projections, 20'000) << name;
    EXPECT_TRUE(is_whole(framework, x, {})) << name;
    for (Joint joint : {0, 2000, 8000, 16'000, 19'999})
      EXPECT_TRUE(x[joint] == sketch.positions[joint]) << name << " " << joint;
  }
}

/// The far one is broken too, and lies behind bars that are whole.
TEST(Near, LooksAtJointsThatNoBrokenBarLeadsTo) {
  const Sketch sketch = ring(30);
  const Framework framework = framework_of(sketch);
  const std::vector<Joint> joints = {0, 15};
  for (const TechniqueEntry& row : techniques()) {
    if (row.forests_only) continue;
    std::vector<Vec3> x = sketch.positions;
    x[15] += {0.01, 0.02, 0.01};  // the root itself has not moved
    Resolver resolver(framework, {std::string(row.name), 0.5});
    EXPECT_TRUE(resolver.resolve(x, {0, false, joints}).converged()) << row.name;
    EXPECT_TRUE(is_whole(framework, x, {})) << row.name;
  }
}

/// Joints in one place are more than a block alone can part: all bars are looked at after all.
TEST(Near, WhatANearPassCannotResolveIsResolvedFromTheStart) {
  const Sketch sketch = ring(30);
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> near = sketch.positions;
  near[3] = near[2];
  std::vector<Vec3> all = near;
  const std::vector<Joint> joints = {0, 3};
  Resolver resolver(framework, {"blocks"});
  const ResolveSummary summary = resolver.resolve(near, {0, false, joints});
  EXPECT_FALSE(resolver.moved());
  EXPECT_EQ(summary.projections, resolver.resolve(all, 0).projections);
  EXPECT_TRUE(test::same_bits(near, all));
  EXPECT_TRUE(summary.converged());
}

TEST(Near, OverflowPutsThePositionsBack) {
  const Framework framework = framework_of(chain(50));
  for (const char* name : {"blocks", "auto"}) {
    std::vector<Vec3> x = chain(50).positions;
    x[20].y = 1e200;
    const std::vector<Vec3> before = x;
    EXPECT_EQ(Resolver(framework, {name, 0.5}).resolve_near(x, 20).stop, Stop::not_finite);
    EXPECT_TRUE(test::same_bits(x, before)) << name;
    const std::vector<Joint> joints = {10, 20, 21};
    Resolver resolver(framework, {name, 0.5});
    EXPECT_EQ(resolver.resolve(x, {10, false, joints}).stop, Stop::not_finite);
    EXPECT_TRUE(test::same_bits(x, before)) << name;
  }
}

constexpr double most_growth = 20.0;

class NearnessLaw : public test::TechniqueLaw {};

double farthest(std::span<const Vec3> a, std::span<const Vec3> b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, distance(a[k], b[k]));
  return most;
}

/// How much further than `size` some joint moves where each of `joints` is pushed by it.
double growth(const Framework& framework, std::span<const Vec3> positions, const char* technique,
              double size, Joint root, bool all) {
  std::vector<Vec3> x(positions.begin(), positions.end());
  for (Joint joint = all ? 0 : root; joint < (all ? x.size() : root + 1); ++joint)
    if (!framework.is_pinned(joint))
      x[joint] +=
          size * framework.random_direction(RandomSequence({7, Domain::force, 0, 0, joint}));
  const std::vector<Vec3> pushed = x;
  Resolver(framework, {technique}).resolve(x, root, 0, positions);
  return farthest(x, pushed) / size;
}

TEST_P(NearnessLaw, NoJointMovesMuchFurtherThanThePush) {
  const std::string technique(GetParam().name);
  each_example([&](const Example& example) {
    if (!example.facts.whole || example.positions.empty()) return;
    const double bar = test::shortest_bar(example.framework);
    for (double size : {0.001, 0.01, 0.1})
      for (Joint root : {Joint{0}, static_cast<Joint>(example.positions.size() / 2)})
        for (bool all : {false, true})
          EXPECT_LE(growth(example.framework, example.positions, technique.c_str(), size * bar,
                           root, all),
                    most_growth)
              << size << (all ? ", all joints" : ", one joint") << ", root " << root;
  });
}

PLIANT_FOR_ALL_TECHNIQUES(NearnessLaw);

/// A zigzag whose angles are held, and whose torsions are free: a chain without side groups, on
/// which an error of one unit is a swing of the next.
Sketch zigzag(std::size_t joints) { return with_angles(shaken(chain(joints), 0.2)); }

TEST(Nearness, HoldsOnLongThinChains) {
  for (std::size_t joints : {100, 1000, 10'000}) {
    const Sketch sketch = zigzag(joints);
    const Framework framework = framework_of(sketch);
    for (const char* technique : {"auto", "units"})
      for (double size : {0.001, 0.01, 0.1})
        for (bool all : {false, true})
          EXPECT_LE(growth(framework, sketch.positions, technique, size,
                           static_cast<Joint>(joints / 3), all),
                    most_growth)
              << technique << " " << joints << " " << size << (all ? " all" : " one");
  }
}

}  // namespace pliant::near_law_test
