// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/drawn_shapes.hpp"

#include <gtest/gtest.h>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/bodies/region/region_planner.hpp"
#include "support/frameworks.hpp"

namespace pliant::drawn_shapes_test {

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

}  // namespace pliant::drawn_shapes_test
