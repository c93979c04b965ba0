// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/check_positions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace check_positions_test {

/// What is said of unit bars with all coordinates shifted by `offset`: an error, or warnings.
std::string verdict_at(double offset, const Tolerance& tolerance = {}) {
  const Sketch sketch = chain(3);
  std::vector<Vec3> x = sketch.positions;
  for (Vec3& p : x) p += Vec3{offset, offset, offset};
  std::string said;
  const Log log{[&](Severity severity, std::string_view text) {
    EXPECT_EQ(severity, Severity::warning);
    said += text;
  }};
  const std::string thrown = test::error_text<InputError>(
      [&] { check_positions(framework_of(sketch), x, tolerance, log); });
  return thrown == test::no_error ? said : "error: " + thrown;
}

TEST(CheckPositions, SaysNothingNearTheOrigin) {
  EXPECT_EQ(verdict_at(0.0), "");
  EXPECT_EQ(verdict_at(1e6), "");
  EXPECT_EQ(verdict_at(1e8), "");
}

/// At 1e8 Angstrom doubles are 1.5e-8 apart: the default tolerance can be met, 1e-10 cannot.
TEST(CheckPositions, WarnsWhereTheToleranceCannotBeMet) {
  EXPECT_EQ(verdict_at(1e8, {.relative = 1e-10}),
            "coordinates reach 1e+08 Angstrom, where doubles are 2.2e-08 apart: the tolerance of "
            "bar 0 - 1 cannot be met");
  EXPECT_EQ(verdict_at(-1e8, {.relative = 1e-6, .length = 1e-9}),
            "coordinates reach 1e+08 Angstrom, where doubles are 2.2e-08 apart: the tolerance of "
            "bar 0 - 1 cannot be met");
}

/// At 1e16 they are 2 apart: unit bars collapse.
TEST(CheckPositions, RefusesWhereDoublesAreCoarserThanBars) {
  EXPECT_EQ(verdict_at(1e16),
            "error: coordinates reach 1e+16 Angstrom, where doubles are 2.2 apart: too coarse for "
            "bar 0 - 1; move the molecule to the origin");
}

TEST(CheckPositions, RefusesWhereSquaresOverflow) {
  EXPECT_EQ(verdict_at(1e160),
            "error: coordinates reach 1e+160 Angstrom: must be within 1e150 of the origin");
}

TEST(CheckPositions, RefusesWhatIsNotFinite) {
  EXPECT_EQ(verdict_at(std::nan("")), "error: position of joint 0 is not finite");
  EXPECT_EQ(verdict_at(HUGE_VAL), "error: position of joint 0 is not finite");
}

TEST(CheckPositions, RefusesAnotherNumberOfPositions) {
  EXPECT_EQ(test::error_text<InputError>(
                [] { check_positions(framework_of(chain(3)), std::vector<Vec3>(2), {}, {}); }),
            "framework: 3 joints but 2 positions");
}

TEST(CheckPositions, TakesJointsWithoutBars) {
  EXPECT_NO_THROW(check_positions(Framework({.joint_count = 2}),
                                  std::vector<Vec3>(2, Vec3{1e16, 0, 0}), {}, {}));
}

}  // namespace check_positions_test
}  // namespace pliant
