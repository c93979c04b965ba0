// SPDX-License-Identifier: MIT
#include "pliant/resolve/shake/shake.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"
#include "unit/resolve/gromacs_systems.hpp"

namespace pliant {
namespace shake_test {

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

/// Joints move by a sum of multiples of the directions at the reference, over their mass.
TEST(Shake, KeepsTheCentreOfMass) {
  const Sketch sketch = ring(7);
  const Framework framework = test::with_masses(framework_of(sketch));
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.2);
  const Vec3 before = test::centre_of_mass(framework, x);
  EXPECT_TRUE(shake_from(framework, x, sketch.positions, 1e-12).converged());
  EXPECT_LT(distance(test::centre_of_mass(framework, x), before), 1e-14);
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
  EXPECT_EQ(test::error_text<OptionError>(
                [&] { Resolver(framework, {"shake"}).resolve(x, 0, 0, std::vector<Vec3>(3)); }),
            "reference: 3 positions for 4 joints");
}

}  // namespace shake_test
}  // namespace pliant
