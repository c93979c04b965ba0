// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/region_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"

namespace pliant::region_planner_test {

/// What every plan must be: parents first, own joints once, copies of joints that others have.
void expect_sound(const BodyPlan& plan) {
  for (std::size_t k = 0; k < plan.bodies().size(); ++k) {
    const PlanBody& body = plan.bodies()[k];
    EXPECT_LT(body.parent, static_cast<std::int32_t>(k));
    for (Slot at = body.first; at < body.last; ++at) EXPECT_EQ(plan.body_at()[at], k);
    if (body.parent < 0) continue;
    EXPECT_LT(body.a, body.first);
    EXPECT_LT(body.b, body.first);
  }
  for (const LoopCut& cut : plan.cuts()) {
    EXPECT_EQ(plan.joint_at()[cut.copy], plan.joint_at()[cut.joint]);
    EXPECT_NE(plan.body_at()[cut.copy], plan.body_at()[cut.joint]);
    EXPECT_EQ(plan.tree_of(plan.body_at()[cut.copy]), plan.tree_of(plan.body_at()[cut.joint]));
  }
  std::size_t bodies = 0;
  for (const BodyTree& tree : plan.trees()) bodies += tree.last - tree.first;
  EXPECT_EQ(bodies, plan.bodies().size());
}

std::set<Joint> moving(const BodyPlan& plan) {
  std::set<Joint> joints;
  for (Slot at = 0; at < plan.place_count(); ++at)
    if (!plan.is_ground(plan.body_at()[at]) && plan.place_of(plan.joint_at()[at]) == at)
      joints.insert(plan.joint_at()[at]);
  return joints;
}

/// No bar leads from a joint that moves to one outside the region: else it would break.
void expect_closed_by_ground(const Framework& framework, const BodyPlan& plan) {
  const auto joint_at = plan.joint_at();
  const std::set<Joint> all(joint_at.begin(), joint_at.end());
  for (Joint joint : moving(plan))
    for (const Incidence& at : framework.neighbours(joint)) EXPECT_TRUE(all.contains(at.joint));
}

TEST(RegionPlanner, PlansAroundAnyJointOfAnyMolecule) {
  for (const auto& entry : std::filesystem::directory_iterator(molecules_folder())) {
    SCOPED_TRACE(entry.path().filename().string());
    const Structure structure = test::bonded(entry.path());
    const Framework framework = build_framework(structure, {.bars = BarKind::angles});
    RegionPlanner planner(framework);
    const auto stride = static_cast<Joint>(1 + framework.joint_count() / 40);
    for (Joint joint = 0; joint < framework.joint_count(); joint += stride)
      for (std::size_t most : {1, 6, 18, 300}) {
        const BodyPlan& plan = planner.plan(std::vector<Joint>{joint}, most);
        expect_sound(plan);
        expect_closed_by_ground(framework, plan);
        EXPECT_TRUE(moving(plan).contains(joint) || plan.is_ground(0));
      }
  }
}

TEST(RegionPlanner, IsNoLargerInALongerChain) {
  std::size_t bodies[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const Sketch sketch = with_angles(shaken(chain(k == 0 ? 1000 : 20'000), 0.2));
    const Framework framework = framework_of(sketch);
    RegionPlanner planner(framework);
    const BodyPlan& plan = planner.plan(std::vector<Joint>{500}, 18);
    bodies[k] = plan.bodies().size();
    EXPECT_TRUE(plan.is_ground(0));
    EXPECT_FALSE(plan.cuts().empty());  // it hangs on the ground at both ends
  }
  EXPECT_EQ(bodies[0], bodies[1]);
  EXPECT_LE(bodies[0], 20u);
}

TEST(RegionPlanner, ASmallMoleculeMovesFreely) {
  const Framework framework = framework_of(with_angles(shaken(chain(12), 0.2)));
  RegionPlanner planner(framework);
  const BodyPlan& plan = planner.plan(std::vector<Joint>{5}, 18);
  EXPECT_FALSE(plan.is_ground(0));
  EXPECT_TRUE(plan.cuts().empty());
  EXPECT_EQ(moving(plan).size(), 12u);
}

/// The hydrogens of a methyl group ride on the next unit, but turn if they are pushed themselves.
TEST(RegionPlanner, EndsRideUnlessTheyArePushed) {
  const Framework framework = framework_of(with_angles(shaken(chain(40), 0.2)));
  RegionPlanner planner(framework);
  const std::size_t away = planner.plan(std::vector<Joint>{20}, 60).bodies().size();
  const std::size_t at_end = planner.plan(std::vector<Joint>{0}, 60).bodies().size();
  EXPECT_EQ(at_end, away + 1);
}

/// Two pushes far from each other hang on one ground.
TEST(RegionPlanner, SeveralPushesShareTheGround) {
  const Framework framework = framework_of(with_angles(shaken(chain(400), 0.2)));
  RegionPlanner planner(framework);
  const BodyPlan& plan = planner.plan(std::vector<Joint>{100, 300}, 30);
  expect_sound(plan);
  EXPECT_EQ(plan.trees().size(), 1u);
  EXPECT_TRUE(moving(plan).contains(100) && moving(plan).contains(300));
  EXPECT_FALSE(moving(plan).contains(200));
}

}  // namespace pliant::region_planner_test
