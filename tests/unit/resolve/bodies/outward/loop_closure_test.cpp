// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/loop_closure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace loop_closure_test {

/// A puckered ring of n joints, with bars across its angles.
Sketch crown(std::size_t n, double height = 0.5) {
  Sketch sketch = ring(n);
  for (std::size_t k = 0; k < n; ++k)
    sketch.positions[k].z = height * std::cos(3.0 * 2.0 * std::numbers::pi * double(k) / double(n));
  return with_angles(sketch);
}

std::optional<LoopClosure> closure_of(const Framework& framework) {
  const UnitSet bodies = find_units(framework);
  return LoopClosure::make(bodies, find_unit_shapes(framework, bodies, {}),
                           connect_units(framework, bodies));
}

class LoopsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(LoopsOf, CloseToRounding) {
  const Sketch sketch = crown(GetParam());
  const Framework framework = framework_of(sketch);
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1, seed);
    ASSERT_TRUE(closure->close(x, 1e-12)) << seed;
    EXPECT_LT(measure(framework, x).max_relative, 1e-11) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, LoopsOf, testing::Values(8, 9, 12, 20, 60));

/// Two rings that share a joint, and a third on one of them: closed together.
TEST(LoopClosure, ClosesSeveralLoopsAtOnce) {
  Sketch sketch = crown(10);
  sketch.bars.resize(10);  // without those across angles, which come anew
  for (const Joint at : {0u, 5u}) {
    const Sketch other = crown(9);
    const auto first = static_cast<Joint>(sketch.positions.size());
    const Vec3 shift = sketch.positions[at] - other.positions[0];
    for (std::size_t k = 1; k < 9; ++k) {
      const Vec3 p = other.positions[k] - other.positions[0];
      const double side = at == 0 ? 1.0 : -1.0;
      sketch.positions.push_back(other.positions[0] + shift + Vec3{-side * p.x, p.z, p.y});
    }
    for (Joint k = first; k + 1 < first + 8; ++k) sketch.bars.push_back({k, k + 1});
    sketch.bars.push_back({at, first});
    sketch.bars.push_back({at, first + 7});
  }
  const Framework framework = framework_of(with_angles(sketch));
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1);
  ASSERT_TRUE(closure->close(x, 1e-12));
  EXPECT_LT(measure(framework, x).max_relative, 1e-11);
}

/// One bar of an unbranched ring of eight taken much too long: angles and bonds cannot all be met.
TEST(LoopClosure, LeavesWhatCannotCloseAsItWas) {
  const Sketch sketch = crown(8);
  FrameworkParts parts = test::parts_of(framework_of(sketch));
  for (std::size_t k = 0; k < 4; ++k) parts.rest_lengths[k] = 0.6;
  for (std::size_t k = 4; k < 8; ++k) parts.rest_lengths[k] = 1.35;
  const Framework framework(std::move(parts));
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.05);
  const std::vector<Vec3> before = x;
  if (!closure->close(x, 1e-10)) {
    EXPECT_TRUE(test::same_bits(x, before));
  } else {
    EXPECT_LT(measure(framework, x).max_relative, 1e-9);
  }
  x[3].y = std::nan("");
  EXPECT_FALSE(closure->close(x, 1e-10));
}

TEST(LoopClosure, RefusesMoreLoopsThanDenseEquationsHold) {
  EXPECT_FALSE(closure_of(framework_of(shaken(grid(9, 9), 0.1))));
}

}  // namespace loop_closure_test
}  // namespace pliant
