// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/region_planner.hpp"

#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/bodies/region/drawn_shapes.hpp"
#include "pliant/resolve/bodies/shape_keeper.hpp"
#include "pliant/resolve/equations/kept_shapes.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

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
  test::each_molecule([](const test::Molecule& m) {
    RegionPlanner planner(m.framework);
    const auto stride = static_cast<Joint>(1 + m.framework.joint_count() / 40);
    for (Joint joint = 0; joint < m.framework.joint_count(); joint += stride)
      for (std::size_t most : {1, 6, 18, 300}) {
        const BodyPlan& plan = planner.plan(std::vector<Joint>{joint}, most);
        expect_sound(plan);
        expect_closed_by_ground(m.framework, plan);
        EXPECT_TRUE(moving(plan).contains(joint) || plan.is_ground(0));
      }
  });
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

Framework drawn_framework(const Sketch& sketch) {
  FrameworkParts parts = test::parts_of(framework_of(sketch));
  parts.drawn = sketch.positions;
  return Framework(std::move(parts));
}

struct Region {
  Framework framework;
  RegionPlanner planner;
  const BodyPlan& plan;
  std::vector<Vec3> x;

  explicit Region(const Sketch& sketch)
      : framework(drawn_framework(sketch)),
        planner(framework),
        plan(planner.plan(std::vector<Joint>{15}, 60)) {
    for (Joint joint : plan.joint_at()) x.push_back(sketch.positions[joint]);
  }
  std::vector<Vec3> restored(std::span<const Vec3> start) const {
    std::vector<Vec3> out(start.begin(), start.end());
    DrawnShapes(framework).restore(planner.units(), plan.joint_at(), start, out);
    return out;
  }
  /// The worst length error of a bar between the places that joints have (Angstrom).
  double worst(std::span<const Vec3> places) const {
    double worst = 0.0;
    for (Joint joint : plan.joint_at())
      for (const Incidence& at : framework.neighbours(joint)) {
        const Slot one = plan.place_of(joint), other = plan.place_of(at.joint);
        if (other == UnitPlaces::none) continue;
        worst = std::max(worst, std::abs(residual(places[one], places[other],
                                                  framework.rest_lengths()[at.bar])));
      }
    return worst;
  }
};

Sketch sketch_of_chain() { return with_angles(shaken(chain(30), 0.25)); }

/// What is a little off is as drawn again, and far ends stay where they were to the same order.
TEST(DrawnShapes, TakeOffWhatRoundingAddsUp) {
  const Region region(sketch_of_chain());
  std::vector<Vec3> off = region.x;
  RandomSequence draws({3, Domain::generate});
  for (Vec3& x : off) x += 1e-9 * draws.direction();
  const std::vector<Vec3> out = region.restored(off);
  EXPECT_GT(region.worst(off), 1e-10);
  EXPECT_LT(region.worst(out), 1e-13);
  EXPECT_LT(test::largest_difference(out, off), 1e-6);
}

TEST(DrawnShapes, ChangeWhatIsAsDrawnByRoundingAlone) {
  const Region region(sketch_of_chain());
  EXPECT_LT(test::largest_difference(region.restored(region.x), region.x), 1e-12);
}

TEST(DrawnShapes, LeaveAllAsItIsWhereAUnitHasAnotherShape) {
  const Region region(sketch_of_chain());
  std::vector<Vec3> other = region.restored(region.x);
  other[region.planner.units().back().first] += Vec3{0, 0, 0.3};
  EXPECT_TRUE(test::same_bits(region.restored(other), other));
}

/// A centre a little above the plane of its three neighbours, all held to each other: its mirror
/// image has the same lengths.
Framework flat_group(std::vector<Joint> pinned = {}) {
  FrameworkParts parts{.joint_count = 4,
                       .bars = complete(4).bars,
                       .pinned = std::move(pinned),
                       .drawn = {{0, 0, 0.05}, {1.4, 0, 0}, {-0.7, 1.2, 0}, {-0.7, -1.2, 0}}};
  for (Bar bar : parts.bars)
    parts.rest_lengths.push_back(distance(parts.drawn[bar.a], parts.drawn[bar.b]));
  return Framework(std::move(parts));
}

/// Of joint 0 above the plane of the others, when those are passed against the clock (Angstrom^3).
double volume(std::span<const Vec3> x) { return dot(x[0] - x[1], cross(x[2] - x[1], x[3] - x[1])); }

std::vector<Vec3> mirrored(std::span<const Vec3> x) {
  std::vector<Vec3> y(x.begin(), x.end());
  for (Vec3& p : y) p.z = -p.z;
  return y;
}

class ShapeKeeper : public testing::TestWithParam<const char*> {};

TEST_P(ShapeKeeper, PutsAnAtomBackOnItsSideOfThePlane) {
  const Framework framework = flat_group();
  const double drawn = volume(framework.drawn());
  for (double height : {-0.3, -0.1, -0.05, 0.02, 0.3}) {
    std::vector<Vec3> x(framework.drawn().begin(), framework.drawn().end());
    x[0].z = height;
    const ResolveSummary summary =
        Resolver(framework, {GetParam()}).resolve(x, 0, 0, framework.drawn());
    EXPECT_TRUE(summary.converged()) << height;
    EXPECT_NEAR(volume(x), drawn, 1e-2 * drawn) << height;
  }
}

TEST_P(ShapeKeeper, LeavesWhatWasMirroredBeforeThePush) {
  const Framework framework = flat_group();
  const std::vector<Vec3> before = mirrored(framework.drawn());
  std::vector<Vec3> x = before;
  x[1].x += 0.05;
  EXPECT_TRUE(Resolver(framework, {GetParam()}).resolve(x, 1, 0, before).converged());
  EXPECT_NEAR(volume(x), volume(before), -1e-2 * volume(before));
}

TEST_P(ShapeKeeper, LeavesPinnedJoints) {
  const Framework framework = flat_group({1, 2, 3});
  std::vector<Vec3> x(framework.drawn().begin(), framework.drawn().end());
  x[0].z = -0.1;
  Resolver(framework, {GetParam()}).resolve(x, 0, 0, framework.drawn());
  for (Joint joint : {1, 2, 3}) EXPECT_TRUE(x[joint] == framework.drawn()[joint]) << joint;
}

INSTANTIATE_TEST_SUITE_P(Direct, ShapeKeeper, testing::Values("newton", "shake"),
                         [](const auto& row) { return std::string(row.param); });

TEST(KeptShapes, AreThoseOfDrawnUnitsOfFourJoints) {
  EXPECT_FALSE(KeptShapes(flat_group(), {}).empty());
  EXPECT_TRUE(KeptShapes(framework_of(chain(9)), {}).empty()) << "no units";
  FrameworkParts lengths_alone = test::parts_of(flat_group());
  lengths_alone.drawn = {};
  EXPECT_TRUE(KeptShapes(Framework(std::move(lengths_alone)), {}).empty());
  FrameworkParts of_the_plane = test::parts_of(framework_of(grid(2, 2)));
  of_the_plane.planar = true;
  EXPECT_TRUE(KeptShapes(Framework(std::move(of_the_plane)), {}).empty());
}

}  // namespace pliant::region_planner_test
