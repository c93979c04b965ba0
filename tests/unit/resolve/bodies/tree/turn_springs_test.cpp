// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/turn_springs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "pliant/base/math/elementary.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/framework/sterics.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"

namespace pliant {
namespace turn_springs_test {

constexpr double degrees = std::numbers::pi / 180.0;

/// Four joints of a chain with bars for bonds and angles, its ends far out as those of long side
/// chains, whose one torsion is `torsion` degrees.
std::vector<Vec3> chain(double torsion) {
  const double c = std::cos(torsion * degrees), s = std::sin(torsion * degrees);
  return {{-0.5, 8.0, 0}, {0, 0, 0}, {1.5, 0, 0}, {2.0, 8.0 * c, 8.0 * s}};
}

Framework framework_of(const std::vector<Vec3>& drawn, double free, bool is_reversed) {
  FrameworkParts parts{
      .joint_count = 4, .bars = {{0, 1}, {1, 2}, {2, 3}, {0, 2}, {1, 3}}, .drawn = drawn};
  for (Bar bar : parts.bars) parts.rest_lengths.push_back(distance(drawn[bar.a], drawn[bar.b]));
  const std::array<Joint, 4> joints =
      is_reversed ? std::array<Joint, 4>{3, 2, 1, 0} : std::array<Joint, 4>{0, 1, 2, 3};
  parts.torsion_preferences = std::make_shared<const TorsionPreferences>(
      TorsionPreferences{.staggered = {{joints, free * degrees}}});
  // Spheres of no size, so that steps with contacts are taken at all.
  parts.sterics = std::make_shared<const Sterics>(
      Sterics{.kind_count = 1, .kinds = {0, 0, 0, 0}, .least = {1.6}, .excluded_bonds = 2});
  return Framework(std::move(parts));
}

double torsion_of(std::span<const Vec3> x) {
  return torsion_angle(x[0], x[1], x[2], x[3]) / degrees;
}

/// Where a spring pulls, the angle asked for leads to the edge of what is usual, to first order
/// exactly: turns are about the bond.
TEST(TurnSprings, AskForTheEdgeOfWhatIsUsual) {
  for (const bool is_reversed : {false, true})
    for (double now = -178.0; now < 180.0; now += 4.0) {
      const std::vector<Vec3> x = chain(now);
      const Framework framework = framework_of(x, 20.0, is_reversed);
      const BodyPlan plan = *BodyPlan::make(framework);
      std::vector<Vec3> placed;
      for (Joint joint : plan.joint_at()) placed.push_back(x[joint]);
      TurnSprings springs(framework, plan);
      ASSERT_FALSE(springs.empty());
      const auto found = springs.at(placed, 50.0);
      ASSERT_EQ(found.size(), 1U);
      const double off = off_staggered(now * degrees) / degrees;
      if (std::abs(off) < 20.0) {
        EXPECT_EQ(found[0].weight, 0.0) << now;
        EXPECT_EQ(found[0].force, 0.0) << now;
        continue;
      }
      EXPECT_EQ(found[0].weight, 50.0) << now;
      EXPECT_NEAR(std::abs(found[0].force) / 50.0, (std::abs(off) - 20.0) * degrees, 1e-7) << now;
    }
}

/// What is pushed to an eclipsed torsion and rests there comes back towards staggered, whichever
/// way the torsion is named; without a preference it stays.
TEST(TurnSprings, PullAnEclipsedTorsionBack) {
  for (const bool is_reversed : {false, true})
    for (const double pushed : {100.0, 110.0, -20.0, 25.0}) {
      const std::vector<Vec3> start = chain(60.0);
      const auto turned_by = [&](double free) {
        const Framework framework = framework_of(start, free, is_reversed);
        const BodyPlan plan = *BodyPlan::make(framework);
        FrodaSolver solver(framework, plan);
        std::vector<Vec3> out(4);
        FrodaOptions options;
        options.is_careful = true;
        options.has_torsion_preferences = true;
        const FrodaResult result = solver.resolve(start, chain(pushed), out, options);
        EXPECT_TRUE(result.is_whole);
        EXPECT_LT(measure(framework, out).max_relative, 1e-12);
        return torsion_of(out);
      };
      const double held = turned_by(15.0), free = turned_by(60.0);
      EXPECT_LT(std::abs(off_staggered(held * degrees)), std::abs(off_staggered(free * degrees)))
          << pushed << ": " << held << " and " << free;
    }
}

/// The ends may be no nearer than at 115 degrees, and the torsion prefers 60 to 75.
TEST(TurnSprings, LetGoWhereContactsWouldNotHoldAgainstThem) {
  const std::vector<Vec3> start = chain(118.0), nearest = chain(115.0);
  FrameworkParts parts = framework_of(start, 15.0, false).parts();
  parts.sterics =
      std::make_shared<const Sterics>(Sterics{.kind_count = 1,
                                              .kinds = {0, 0, 0, 0},
                                              .least = {distance(nearest[0], nearest[3])},
                                              .excluded_bonds = 2,
                                              .bonds = {{0, 1}, {1, 2}, {2, 3}}});
  const Framework framework(std::move(parts));
  const BodyPlan plan = *BodyPlan::make(framework);
  FrodaSolver solver(framework, plan);
  std::vector<Vec3> out(4);
  FrodaOptions options;
  options.is_careful = true;
  options.has_torsion_preferences = true;
  const FrodaResult result = solver.resolve(start, chain(80.0), out, options);
  EXPECT_TRUE(result.is_whole);
  EXPECT_LE(result.max_overlap, options.goal);
  EXPECT_NEAR(torsion_of(out), 115.0, 0.5);
}

}  // namespace turn_springs_test
}  // namespace pliant
