// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/loads.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"

namespace pliant::loads_test {

constexpr double accuracy = 1e-2;

Loads loads_of(const Framework& framework, std::span<const Vec3> x, Joint joint, Vec3 force) {
  const Load pull{joint, force};
  return find_loads(framework, x, {&pull, 1});
}

/// A rod of n joints drawn along itself: each gives way by 1/n, and tension falls off evenly.
TEST(Loads, OfAStraightChain) {
  const Sketch sketch = straight_chain(5);
  const Loads found = loads_of(framework_of(sketch), sketch.positions, 4, {1.0, 0.0, 0.0});
  EXPECT_NEAR(found.yields(4, {1.0, 0.0, 0.0}), 0.2, accuracy);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(found.bars[k], 0.2 * (k + 1), accuracy) << k;
  const Loads pressed = loads_of(framework_of(sketch), sketch.positions, 4, {-1.0, 0.0, 0.0});
  EXPECT_NEAR(pressed.bars[3], -0.8, accuracy);
  const Loads across = loads_of(framework_of(sketch), sketch.positions, 4, {0.0, 1.0, 0.0});
  EXPECT_NEAR(across.yields(4, {0.0, 1.0, 0.0}), 1.0, accuracy) << "no bar holds it";
}

TEST(Loads, OfAPin) {
  const Sketch sketch = straight_chain(3);
  const Framework framework = test::with_pinned(framework_of(sketch), {0});
  const Loads found = loads_of(framework, sketch.positions, 2, {5.0, 0.0, 0.0});
  EXPECT_NEAR(found.pins[0], 5.0, 5 * accuracy);
  EXPECT_NEAR(found.yields(2, {5.0, 0.0, 0.0}), 0.0, accuracy);
  EXPECT_NEAR(found.bars[0], 5.0, 5 * accuracy);
  EXPECT_EQ(found.motion[0], Vec3());
}

/// Two joints and a pinned one: a limit holds one way, and only where it is reached.
TEST(Loads, OfLimitsAreOneSided) {
  FrameworkParts parts;
  parts.joint_count = 2;
  parts.pinned = {0};
  parts.limits = {{0, 1, 0.0, 3.0}};
  const std::vector<Vec3> taut{{}, {2.98, 0.0, 0.0}}, slack{{}, {2.5, 0.0, 0.0}};
  const Framework framework(parts);
  EXPECT_NEAR(loads_of(framework, taut, 1, {1.0, 0.0, 0.0}).limits[0], 1.0, accuracy);
  EXPECT_EQ(loads_of(framework, taut, 1, {-1.0, 0.0, 0.0}).limits[0], 0.0);
  EXPECT_EQ(loads_of(framework, slack, 1, {1.0, 0.0, 0.0}).limits[0], 0.0);
}

/// Of two limits side by side each carries half: neither is named alone.
TEST(Loads, AreSharedByWhatHoldsTogether) {
  FrameworkParts parts;
  parts.joint_count = 3;
  parts.pinned = {0, 1};
  parts.limits = {{0, 2, 0.0, 3.0}, {1, 2, 0.0, 3.0}};
  const std::vector<Vec3> x{{0.0, 0.1, 0.0}, {0.0, -0.1, 0.0}, {3.0, 0.0, 0.0}};
  const Loads found = loads_of(Framework(parts), x, 2, {1.0, 0.0, 0.0});
  EXPECT_NEAR(found.limits[0], found.limits[1], accuracy);
  EXPECT_NEAR(found.limits[0] + found.limits[1], 1.0, accuracy);
}

TEST(Loads, OfJointsThatTouch) {
  FrameworkParts parts;
  parts.joint_count = 2;
  parts.pinned = {0};
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->least = {2.0};
  sterics->kinds = {0, 0};
  parts.sterics = sterics;
  const std::vector<Vec3> x{{}, {2.02, 0.0, 0.0}};
  const Loads found = loads_of(Framework(parts), x, 1, {-1.0, 0.0, 0.0});
  ASSERT_EQ(found.pressed.size(), 1u);
  EXPECT_NEAR(found.pressed[0].load, 1.0, accuracy);
  EXPECT_TRUE(loads_of(Framework(parts), x, 1, {1.0, 0.0, 0.0}).pressed.empty());
}

}  // namespace pliant::loads_test
