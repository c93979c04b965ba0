// SPDX-License-Identifier: MIT
// Volumes whose size and middle are known in closed form.
#include "pliant/fit/accessible_volume.hpp"

#include <numbers>

#include "support/test.hpp"

namespace pliant::accessible_volume_test {

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3 point : points) sum += point;
  return (1.0 / double(points.size())) * sum;
}

bool has(const std::vector<Vec3>& points, Vec3 wanted) {
  return std::ranges::any_of(points, [&](Vec3 x) { return distance(x, wanted) < 1e-6; });
}

TEST(AccessibleVolume, OfAFreePointIsABall) {
  const Vec3 attached{3.3, -7.1, 12.0};
  const std::vector<Vec3> found = accessible_volume({}, {}, attached);
  const double ball = 4.0 / 3.0 * std::numbers::pi * 8000.0;
  EXPECT_GT(double(found.size()), 0.88 * ball);
  EXPECT_LT(double(found.size()), ball);
  EXPECT_LT(distance(mean(found), attached), 1e-9);
}

/// Half a ball, cut where the dye touches the wall: its middle is 3 (r + d)^2 / (4 (2 r + d)) away.
TEST(AccessibleVolume, AtAFlatWallIsACap) {
  const std::vector<Vec3> atoms{{0, 0, -1e5}};
  const std::vector<double> radii{1e5};
  for (const double height : {0.5, 2.5, 6.5}) {
    const Vec3 attached{0, 0, height};
    const Vec3 found = mean(accessible_volume(atoms, radii, attached)) - attached;
    const double cut = 3.0 - height,
                 r = 20.0;  // 3: between the last point taken, 3.5, and the next
    EXPECT_NEAR(found.z, 3.0 * (r + cut) * (r + cut) / (4.0 * (2.0 * r + cut)), 0.3);
    EXPECT_NEAR(found.x, 0.0, 1e-9);
    EXPECT_NEAR(found.y, 0.0, 1e-9);
  }
}

TEST(AccessibleVolume, LinkersGoAroundWhatIsInTheWay) {
  const std::vector<Vec3> ball{{10, 0, 0}};
  const std::vector<double> radius{6.0};
  const std::vector<Vec3> found = accessible_volume(ball, radius, {});
  EXPECT_TRUE(has(found, {0, 19, 0}));
  EXPECT_TRUE(has(found, {-19, 0, 0}));
  EXPECT_FALSE(has(found, {10, 0, 0}));
  EXPECT_FALSE(has(found, {19, 9, 0}));  // 21 as the crow flies
  EXPECT_FALSE(has(found, {19, 0, 0}));  // 19, but 26 around
  EXPECT_TRUE(has(accessible_volume({}, {}, {}), {19, 0, 0}));
}

TEST(AccessibleVolume, IsEmptyWhereNothingIsFree) {
  const std::vector<Vec3> atoms{{1, 0, 0}};
  EXPECT_TRUE(accessible_volume(atoms, std::vector<double>{30.0}, {}).empty());
  EXPECT_ERROR(InputError, "radii: expected one for each atom", accessible_volume(atoms, {}, {}));
  EXPECT_ERROR(OptionError, "length, width, radius of a dye: must be above 0, at most 100 Angstrom",
               accessible_volume({}, {}, {}, {.length = 0.0}));
}

}  // namespace pliant::accessible_volume_test
