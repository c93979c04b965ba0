// SPDX-License-Identifier: MIT
#include "pliant/resolve/newton/newton.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/shake/shake.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/resolve/gromacs_systems.hpp"

namespace pliant::newton_test {

double weighted_squares(const Framework& framework, const std::vector<Vec3>& x,
                        const std::vector<Vec3>& y) {
  double sum = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (framework.inverse_masses()[j] > 0.0)
      sum += norm_squared(x[j] - y[j]) / framework.inverse_masses()[j];
  return sum;
}

TEST(Newton, FindsTheNearestPositionsOfGromacsSystems) {
  for (const test::GromacsSystem& system : test::gromacs_systems()) {
    SCOPED_TRACE(system.name);
    const Framework& framework = find_example(system.name).framework;
    std::vector<Vec3> x = system.pushed;
    const ResolveSummary summary = resolve(framework, {"newton"}, x, {{1e-12}});
    EXPECT_TRUE(summary.converged()) << summary.brief(framework);
    EXPECT_LT(test::largest_difference(x, system.nearest), 1e-14);
    EXPECT_NEAR(weighted_squares(framework, x, system.pushed), system.squares, 1e-15);
  }
}

/// The default tolerance ends the iterations, but the last move brings it nearer than was asked.
TEST(Newton, IsNearestAtALooseTolerance) {
  for (const test::GromacsSystem& system : test::gromacs_systems()) {
    std::vector<Vec3> x = system.pushed;
    resolve(find_example(system.name).framework, {"newton"}, x);
    EXPECT_LT(test::largest_difference(x, system.nearest), 1e-9) << system.name;
  }
}

/// Equal masses at the corners of a triangle too large by a fifth: it shrinks about its centre.
TEST(Newton, ATriangleShrinksAboutItsCentre) {
  const Sketch sketch = ring(3);
  std::vector<Vec3> x = sketch.positions;
  for (Vec3& p : x) p *= 1.2;
  const Vec3 centre = (1.0 / 3.0) * (x[0] + x[1] + x[2]);
  std::vector<Vec3> expected = x;
  for (Vec3& p : expected) p = centre + (1.0 / 1.2) * (p - centre);
  const ResolveSummary summary = resolve(framework_of(sketch), {"newton"}, x, {{1e-13}});
  EXPECT_TRUE(summary.converged());
  EXPECT_LT(test::largest_difference(x, expected), 1e-13);
}

/// A straight chain whose first joint was pushed outwards: the centre of mass stays where the push
/// brought it, so that each of eight joints ends an eighth of the push from where it was.
TEST(Newton, AStraightChainSharesAPush) {
  const Sketch sketch = straight_chain(8);
  std::vector<Vec3> x = sketch.positions;
  x[0].x -= 0.4;
  const ResolveSummary summary = resolve(framework_of(sketch), {"newton"}, x, {{1e-13}});
  EXPECT_TRUE(summary.converged());
  for (std::size_t k = 0; k < x.size(); ++k)
    EXPECT_LT(distance(x[k], sketch.positions[k] - Vec3{0.4 / 8.0, 0, 0}), 1e-12) << k;
}

/// No whole positions near the answer are nearer: moved along any flex and made whole again, they
/// are farther off.
TEST(Newton, NothingNearbyIsNearer) {
  const Sketch sketch = ring(9);
  const Framework framework = test::with_masses(framework_of(sketch));
  const std::vector<Vec3> broken = test::shake(framework, sketch.positions, 0.3);
  std::vector<Vec3> x = broken;
  const ResolveOptions options{.tolerance = {.relative = 1e-13}};
  ASSERT_TRUE(resolve(framework, {"newton"}, x, options).converged());
  const double least = weighted_squares(framework, x, broken);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    std::vector<Vec3> other = test::shake(framework, x, 1e-3, seed);
    ASSERT_TRUE(resolve(framework, {"newton"}, other, options).converged());
    EXPECT_GT(weighted_squares(framework, other, broken), least);
  }
}

/// Ten bars between five joints, nine of them independent.
TEST(Newton, LeavesADependentBarOutAndSaysSo) {
  const Sketch sketch = complete(5);
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.05);
  const ResolveSummary summary = resolve(framework, {"newton"}, x, {{1e-10}});
  EXPECT_TRUE(summary.converged()) << summary.brief(framework);
  EXPECT_EQ(summary.finishing_sweeps, 0);
  EXPECT_EQ(summary.dropped_bars, 1);
  EXPECT_NE(summary.brief(framework).find("dependent bars left out: 1"), std::string::npos);
}

TEST(Newton, LeavesTheImpossibleToSweepsAndSaysSo) {
  const Example& example = find_example("triangle_1_1_3");
  std::vector<Vec3> x = example.positions;
  const ResolveSummary summary = resolve(example.framework, {"newton"}, x, {.max_sweeps = 200});
  EXPECT_EQ(summary.stop, Stop::max_sweeps);
  EXPECT_EQ(summary.sweeps, 200);
  EXPECT_GT(summary.finishing_sweeps, 0);
  EXPECT_TRUE(test::all_finite(x));
}

/// A component that is whole costs nothing and keeps its bits.
TEST(Newton, LeavesWholeComponentsAlone) {
  const Example& example = find_example("openmm_staircase");
  std::vector<Vec3> x = example.positions;
  x[6].x += 0.2;
  const ResolveSummary summary = resolve(example.framework, {"newton"}, x, {{1e-10}});
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.projections, summary.sweeps);
  for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(x[j], example.positions[j]);
}

ResolveSummary shake_from(const Framework& framework, std::vector<Vec3>& x,
                          const std::vector<Vec3>& reference, double tolerance) {
  return Resolver(framework, {"shake"}, {{tolerance}}).resolve(x, 0, 0, reference);
}

TEST(Shake, GivesTheAnswerOfGromacsSystems) {
  for (const test::GromacsSystem& system : test::gromacs_systems()) {
    SCOPED_TRACE(system.name);
    const Example& example = find_example(system.name);
    std::vector<Vec3> x = system.pushed;
    const ResolveSummary summary = shake_from(example.framework, x, example.positions, 1e-14);
    EXPECT_TRUE(summary.converged()) << summary.brief(example.framework);
    EXPECT_EQ(summary.finishing_sweeps, 0);
    EXPECT_LT(test::largest_difference(x, system.shake), 1e-14);
  }
}

/// A bar of length 1 along x, pushed at one end: it comes back along x, whatever the push.
TEST(Shake, MovesAlongTheReference) {
  const Sketch sketch = straight_chain(2);
  std::vector<Vec3> x{{0, 0, 0}, {1.3, 0.6, 0}};
  const ResolveSummary summary = shake_from(framework_of(sketch), x, sketch.positions, 1e-13);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(x[0].y, 0.0);
  EXPECT_EQ(x[1].y, 0.6);
  EXPECT_NEAR(x[1].x - x[0].x, 0.8, 1e-12);
  EXPECT_NEAR(x[1].x + x[0].x, 1.3, 1e-12);
}

TEST(Shake, WithoutAReferenceMovesAlongTheBrokenBars) {
  const Sketch sketch = chain(5);
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.2), y = x;
  const std::vector<Vec3> broken = x;
  EXPECT_TRUE(resolve(framework, {"shake"}, x, {{1e-12}}).converged());
  EXPECT_TRUE(shake_from(framework, y, broken, 1e-12).converged());
  EXPECT_TRUE(test::same_bits(x, y));
}

/// A bar turned by a right angle can't be mended along its old direction.
TEST(Shake, FindsOtherDirectionsWhereThereIsNoAnswer) {
  const Sketch sketch = straight_chain(2);
  std::vector<Vec3> x{{0, 0, 0}, {0, 1.5, 0}};
  const ResolveSummary summary = shake_from(framework_of(sketch), x, sketch.positions, 1e-10);
  EXPECT_TRUE(summary.converged());
  EXPECT_TRUE(test::all_finite(x));
}

TEST(Shake, RefusesAReferenceOfAnotherSize) {
  const Sketch sketch = chain(4);
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = sketch.positions;
  EXPECT_ERROR(OptionError, "reference: 3 positions for 4 joints",
               Resolver(framework, {"shake"}).resolve(x, 0, 0, std::vector<Vec3>(3)));
}

}  // namespace pliant::newton_test
