// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/plausible_shapes.hpp"

#include "pliant/base/math/best_fit.hpp"
#include "support/test.hpp"
#include "unit/sample/two_lobes.hpp"

namespace pliant::plausible_shapes_test {

TEST(PlausibleShapes, DoNotDependOnWhereAShapeLies) {
  const std::vector<Vec3> start = test::two_lobes().positions;
  const PlausibleShapes shapes(start);
  std::vector<Vec3> bent = start, moved;
  for (std::size_t k = start.size() / 2; k < start.size(); ++k) bent[k].z += 6.0;
  const Rotation turn = turn_about({0.6, 0.0, 0.8}, 0.7);
  for (const Vec3 x : bent) moved.push_back(turn(x) + Vec3{10, -20, 30});
  EXPECT_NEAR(shapes.score(moved), shapes.score(bent), 1e-9);
  EXPECT_LT(shapes.score(start), shapes.score(bent)) << "another shape is not the start";
}

TEST(PlausibleShapes, OpenOnesClose) {
  const std::vector<Vec3> start = test::two_lobes().positions;
  const PlausibleShapes shapes(start);
  ASSERT_GT(shapes.openness(), 0.9);
  std::vector<Vec3> nearer = start, further = start;
  const Vec3 along = start.back() - start.front();
  for (std::size_t k = start.size() / 2; k < start.size(); ++k) {
    nearer[k] -= 0.05 * along;
    further[k] += 0.05 * along;
  }
  EXPECT_GT(shapes.score(nearer), shapes.score(further));
}

}  // namespace pliant::plausible_shapes_test
