// SPDX-License-Identifier: MIT
#include "pliant/rigidity/framework_rigidity.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"
#include "support/rigidity.hpp"

namespace pliant {
namespace framework_rigidity_test {

TEST(FrameworkRigidity, RanksOfExamplesAreThoseOfEigen) {
  for (const Example& example : examples()) {
    const FrameworkRigidity found = framework_rigidity(example.framework, example.positions);
    if (example.framework.has_pinned_joints() || !example.facts.whole) continue;
    EXPECT_EQ(found.rank.rank, test::rigidity_rank(example.framework, example.positions))
        << example.name;
    EXPECT_EQ(found.motions.of_whole, test::rigid_motions(example.positions)) << example.name;
    EXPECT_GE(found.generic_rank.rank, found.rank.rank) << example.name;
    EXPECT_GE(found.counted_rank, found.generic_rank.rank) << example.name;
    EXPECT_EQ(found.parts, example.facts.components) << example.name;
  }
}

/// A long chain and its angles: QR, whose bits and numbers are known.
TEST(FrameworkRigidity, AChainOfTenThousandJointsTurnsAboutItsInnerBars) {
  const Sketch sketch = with_angles(shaken(chain(10'000), 0.2));
  const FrameworkRigidity found = framework_rigidity(framework_of(sketch), sketch.positions);
  EXPECT_FALSE(found.rank.has_singular_values);
  EXPECT_EQ(found.motions.internal(), 9'997u);
  EXPECT_EQ(found.generic_motions.internal(), 9'997u);
  EXPECT_EQ(found.counted_motions.internal(), 9'997u);
  EXPECT_TRUE(found.overconstrained.empty());
}

TEST(FrameworkRigidity, OfCompleteGraphsAllBarsAreRedundant) {
  for (const std::size_t joints : {5u, 12u, 30u}) {  // the last by QR
    const Sketch sketch = complete(joints);
    const FrameworkRigidity found = framework_rigidity(framework_of(sketch), sketch.positions);
    EXPECT_EQ(found.rank.rank, 3 * joints - 6);
    ASSERT_EQ(found.overconstrained.size(), 1u);
    EXPECT_EQ(found.overconstrained[0].bars.size(), joints * (joints - 1) / 2);
    EXPECT_EQ(found.overconstrained[0].joints, joints);
    EXPECT_EQ(found.overconstrained[0].self_stresses, (joints - 3) * (joints - 4) / 2);
    EXPECT_EQ(found.generic_rank.redundant, found.rank.redundant);
  }
}

TEST(FrameworkRigidity, SayWhichPositionsAreWrong) {
  const Framework bar = framework_of(straight_chain(2));
  const std::vector<Vec3> one{{0, 0, 0}};
  EXPECT_EQ(test::error_text<InputError>([&] { framework_rigidity(bar, one); }),
            "positions: expected 2, one for each joint, found 1");
}

}  // namespace framework_rigidity_test
}  // namespace pliant
