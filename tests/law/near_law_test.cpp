// SPDX-License-Identifier: MIT
// Laws of Resolver::resolve_near: after a push of one joint where all was whole it does what
// resolve does, to the tolerance, without touching what the push does not reach.
#include <cmath>

#include "law/technique_cases.hpp"
#include "pliant/resolve/resolve.hpp"

namespace pliant {
namespace {

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

PLIANT_FOR_ALL_TECHNIQUES(NearLaw);

TEST(Near, LooksAtNoMoreBarsInALargerFramework) {
  for (const char* name : {"bfs_local", "blocks"}) {
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

/// Bars that are whole are left alone here and polished there: the answers agree to the tolerance.
TEST(Near, LocalSweepsAnswerAsFullSweepsDo) {
  const Sketch sketch = shaken(chain(400), 0.2);
  const Framework framework = framework_of(sketch);
  for (double weighting : {0.5, 0.75, 1.0}) {
    std::vector<Vec3> near = sketch.positions;
    near[200] += {0.02, 0.03, -0.05};
    std::vector<Vec3> full = near;
    Resolver(framework, {"bfs_local", weighting}, {{1e-9}}).resolve_near(near, 200);
    Resolver(framework, {"bfs_cycle", weighting}, {{1e-9}}).resolve(full, 200);
    EXPECT_LT(test::largest_difference(near, full), 1e-6) << weighting;
  }
}

TEST(Near, OverflowPutsThePositionsBack) {
  const Framework framework = framework_of(chain(50));
  for (const char* name : {"bfs_local", "blocks"}) {
    std::vector<Vec3> x = chain(50).positions;
    x[20].y = 1e200;
    const std::vector<Vec3> before = x;
    EXPECT_EQ(Resolver(framework, {name, 0.5}).resolve_near(x, 20).stop, Stop::not_finite);
    EXPECT_TRUE(test::same_bits(x, before)) << name;
  }
}

}  // namespace
}  // namespace pliant
