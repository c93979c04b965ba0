// SPDX-License-Identifier: MIT
#include "pliant/resolve/auto.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace automatic_test {

TEST(Automatic, ChoosesByWhatTheBarsForm) {
  const Choice tree = choose_technique(framework_of(chain(5)));
  EXPECT_EQ(tree.technique.name, "blocks");
  EXPECT_EQ(tree.why, "the bars close no cycle: one outward pass makes them whole");
  const Choice hexagon = choose_technique(framework_of(ring(6)));
  EXPECT_EQ(hexagon.technique.name, "blocks");
  EXPECT_EQ(hexagon.why,
            "1 ring system, each by Newton's method, and 0 bridges in one outward pass");
  const Choice angles = choose_technique(framework_of(with_angles(shaken(chain(9), 0.2))));
  EXPECT_EQ(angles.technique.name, "units");
  EXPECT_EQ(angles.why, "most bars are in triangles: rigid units in one outward pass");
  const Choice water = choose_technique(framework_of(ring(3)));
  EXPECT_EQ(water.technique.name, "blocks") << "one triangle is quicker by Newton than as a unit";
  EXPECT_EQ(choose_technique(framework_of(complete(4))).technique.name, "blocks");
  EXPECT_EQ(choose_technique(framework_of(complete(5))).technique.name, "units");
  const Choice hub = choose_technique(framework_of(complete(80)));
  EXPECT_EQ(hub.technique.name, "anderson");
  const Framework pinned = test::with_pinned(framework_of(ring(6)), {0, 3});
  EXPECT_EQ(choose_technique(pinned).technique.name, "newton");
  EXPECT_TRUE(choose_technique(pinned, {"auto", 0.5, true}).technique.mass_weighted);
}

/// `moving` and, after it, `still`, all of whose joints are pinned.
Framework beside_pinned(const Sketch& moving, const Sketch& still) {
  FrameworkParts parts = test::parts_of(framework_of(moving));
  const auto first = static_cast<Joint>(moving.positions.size());
  const Framework other = framework_of(still);
  for (std::size_t k = 0; k < other.bar_count(); ++k) {
    const Bar bar = other.bars()[k];
    parts.bars.push_back({bar.a + first, bar.b + first});
    parts.rest_lengths.push_back(other.rest_lengths()[k]);
  }
  parts.joint_count += other.joint_count();
  parts.masses.clear();
  parts.drawn.clear();
  for (Joint joint = 0; joint < other.joint_count(); ++joint) parts.pinned.push_back(first + joint);
  return Framework(std::move(parts));
}

TEST(Automatic, ComponentsThatArePinnedAsAWholeChangeNothing) {
  for (const Sketch& moving : {shaken(chain(20), 0.2), ring(7), shaken(grid(3, 3), 0.1)}) {
    const Framework alone = framework_of(moving);
    for (const Sketch& still : {chain(4), ring(5), ring(3)}) {
      const Framework both = beside_pinned(moving, still);
      EXPECT_EQ(choose_technique(both).technique.name, "blocks");
      std::vector<Vec3> x = test::shake(alone, moving.positions, 0.1), y = x;
      y.insert(y.end(), still.positions.begin(), still.positions.end());
      EXPECT_TRUE(resolve(alone, {}, x).converged());
      EXPECT_TRUE(resolve(both, {}, y).converged());
      EXPECT_LE(test::largest_difference(x, std::span(y).first(x.size())), 1e-12);
      EXPECT_TRUE(test::same_bits(still.positions, std::span(y).subspan(x.size())));
    }
  }
}

TEST(Automatic, PinsThatBindAComponentAreToldFromThoseThatDoNot) {
  const Framework two_rings = beside_pinned(ring(6), ring(6));
  FrameworkParts parts = test::parts_of(two_rings);
  parts.pinned = {0, 6};
  EXPECT_EQ(choose_technique(Framework(parts)).technique.name, "blocks") << "one in each";
  parts.pinned = {0, 3, 6};
  EXPECT_EQ(choose_technique(Framework(parts)).technique.name, "newton");
  parts.pinned = {0, 6, 7, 8, 9, 10, 11};
  EXPECT_EQ(choose_technique(Framework(parts)).technique.name, "blocks");
  parts.pinned.clear();
  for (Joint joint = 0; joint < 12; ++joint) parts.pinned.push_back(joint);
  EXPECT_EQ(choose_technique(Framework(parts)).technique.name, "blocks") << "nothing moves";
}

/// Ions and dummy sites beside a molecule.
TEST(Automatic, DoesNotCountJointsWithoutBars) {
  Sketch sketch = with_angles(shaken(chain(9), 0.2));
  for (int k = 0; k < 100; ++k) sketch.positions.push_back({10.0 + k, 0, 0});
  EXPECT_EQ(choose_technique(framework_of(sketch)).technique.name, "units");
}

/// A star has a hub but no cycle; no bar at all is no cycle either.
TEST(Automatic, TakesTheOutwardPassWhereItIsExact) {
  EXPECT_EQ(choose_technique(framework_of(star(500))).technique.name, "blocks");
  EXPECT_EQ(choose_technique(framework_of(chain(1))).technique.name, "blocks");
}

TEST(Automatic, DoesWhatTheChosenTechniqueDoes) {
  for (const Sketch& sketch :
       {shaken(chain(20), 0.2), ring(7), with_angles(shaken(chain(8), 0.2))}) {
    const Framework framework = framework_of(sketch);
    std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1), y = x;
    const ResolveSummary by_auto = resolve(framework, {}, x);
    const ResolveSummary by_name = resolve(framework, choose_technique(framework).technique, y);
    EXPECT_TRUE(by_auto.converged());
    EXPECT_EQ(by_auto.projections, by_name.projections);
    EXPECT_TRUE(test::same_bits(x, y));
    Resolver resolver(framework, {});
    x[3] += Vec3{0.01, 0.0, 0.02};
    EXPECT_TRUE(resolver.resolve_near(x, 3).converged());
  }
}

TEST(Automatic, NamesTheTechniqueUsed) {
  const Framework framework = framework_of(chain(5));
  EXPECT_EQ(technique_used(framework, {}).name, "blocks");
  EXPECT_EQ(technique_used(framework, {"random", 0.75}).name, "random");
  EXPECT_EQ(technique_used(framework, {"random", 0.75}).weighting, 0.75);
}

}  // namespace automatic_test
}  // namespace pliant
