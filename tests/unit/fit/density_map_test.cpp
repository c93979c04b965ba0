// SPDX-License-Identifier: MIT
#include "pliant/base/random.hpp"
#include "pliant/fit/map/blurred.hpp"
#include "pliant/fit/map/read_map.hpp"
#include "pliant/fit/map/simulated.hpp"
#include "pliant/fit/map/spread_rotations.hpp"
#include "pliant/fit/map/write_map.hpp"
#include "support/test.hpp"

namespace pliant::density_map_test {

using test::error_text;

/// Three atoms in a small map whose cell is skewed.
DensityMap skewed_map() {
  MapGrid grid;
  grid.count = {7, 8, 9};
  grid.origin = {-3, 1, 2};
  grid.steps = {Vec3{1.5, 0, 0}, Vec3{-0.6, 1.3, 0}, Vec3{0.3, 0.2, 1.4}};
  const std::vector<Vec3> atoms{{0, 5, 6}, {1, 7, 8}, {2, 4, 9}};
  return simulated(grid, atoms, std::vector<double>{6, 7, 8}, 6.0);
}

TEST(DensityMap, IsASumOfGaussiansOnASkewedGrid) {
  const DensityMap map = skewed_map();
  const double sigma = 0.225 * 6.0;
  for (std::size_t point = 0; point < map.grid().size(); ++point) {
    const Vec3 place = place_of(map.grid(), point);
    double sum = 0.0;
    for (const auto& [atom, weight] :
         {std::pair{Vec3{0, 5, 6}, 6.0}, {Vec3{1, 7, 8}, 7.0}, {Vec3{2, 4, 9}, 8.0}})
      sum += weight * std::exp(-norm_squared(place - atom) / (2 * sigma * sigma));
    ASSERT_NEAR(map.values()[point], sum, 1e-4);
    ASSERT_NEAR(map.at(place).value, map.values()[point], 1e-5);
  }
}

TEST(DensityMap, HasTheGradientOfItsValue) {
  const DensityMap map = skewed_map();
  RandomSequence draws({3, Domain::generate});
  for (int k = 0; k < 200; ++k) {
    const Vec3 place =
        map.grid().place(6 * draws.uniform(), 7 * draws.uniform(), 8 * draws.uniform());
    const DensityAt found = map.at(place);
    for (const Vec3 step : {Vec3{1e-7, 0, 0}, Vec3{0, 1e-7, 0}, Vec3{0, 0, 1e-7}}) {
      const double change = map.at(place + step).value - map.at(place - step).value;
      ASSERT_NEAR(change / 2e-7, dot(found.gradient, step) / 1e-7, 1e-5);
    }
  }
}

TEST(DensityMap, IsNothingOutsideOfItsBox) {
  const DensityMap map = skewed_map();
  const std::vector<Vec3> places{map.grid().place(-0.01, 3, 3), map.grid().place(6, 7, 8),
                                 map.grid().place(3, 3, 8.01), Vec3{NAN, 0, 0}, Vec3{1e300, 0, 0}};
  const DensitiesAt found = map.at(places);
  EXPECT_EQ(found.outside, 4u);
  EXPECT_EQ(found.values[0], 0.0);
  EXPECT_EQ(found.values[3], 0.0);
  EXPECT_GT(found.values[1], 0.0);
}

TEST(DensityMap, IsCroppedAroundAPlace) {
  const DensityMap map = skewed_map();
  const DensityMap part = cropped(map, std::vector<Vec3>{{0, 5, 6}}, 2.0);
  EXPECT_LT(part.grid().size(), map.grid().size() / 3);
  for (const Vec3 place : {Vec3{0, 5, 6}, Vec3{0.4, 5.2, 5.9}})
    EXPECT_NEAR(part.at(place).value, map.at(place).value, 1e-6);
  EXPECT_EQ(error_text<InputError>([&] {
              cropped(map, std::vector<Vec3>{{99, 5, 6}}, 2.0);
            }),
            "density map: the molecule lies outside of it; put it there first (place)");
}

TEST(DensityPyramid, IsWiderAtFirstAndHasAGreatestOfOne) {
  const std::vector<Vec3> atoms{{0, 0, 0}};
  const DensityMap map = simulated(grid_around(atoms, 24.0, 1.0), atoms, std::vector{6.0}, 6.0);
  const std::vector<DensityMap> pyramid = density_pyramid(map, 6.0, 3);
  ASSERT_EQ(pyramid.size(), 3u);
  const double times[]{4, 2, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(pyramid[k].statistics().greatest, 1.0, 1e-6);
    const double sigma = 0.225 * 6.0 * times[k];
    EXPECT_NEAR(pyramid[k].at({4, 0, 0}).value, std::exp(-8.0 / (sigma * sigma)), 2e-3);
  }
}

TEST(SpreadRotations, AreNearToAnyRotation) {
  const std::vector<Rotation> all = spread_rotations(1000);
  const auto nearest_cosine = [&](const Rotation& one) {
    double best = -1.0;
    for (const Rotation& other : all) {
      const double trace = dot(one.x, other.x) + dot(one.y, other.y) + dot(one.z, other.z);
      best = std::max(best, (trace - 1.0) / 2.0);
    }
    return best;
  };
  RandomSequence draws({5, Domain::generate});
  for (int k = 0; k < 100; ++k) {
    const double z = 2 * draws.uniform() - 1, r = std::sqrt(1 - z * z);
    const double way = 6.283 * draws.uniform();
    const Rotation any =
        turn_about({r * std::cos(way), r * std::sin(way), z}, std::tan(1.57 * draws.uniform()));
    EXPECT_GT(nearest_cosine(any), std::cos(40.0 / 57.3));
  }
}

TEST(MapFile, KeepsASkewedMap) {
  const DensityMap map = skewed_map(), read = map_from(map_bytes(map), "x.mrc");
  EXPECT_TRUE(std::ranges::equal(read.values(), map.values()));
  for (std::size_t point : {std::size_t{0}, map.grid().size() - 1})
    EXPECT_LT(distance(place_of(read.grid(), point), place_of(map.grid(), point)), 1e-5);
}

TEST(MapFile, IsRefusedWhereverItIsCut) {
  const std::string bytes = map_bytes(skewed_map());
  for (std::size_t size = 0; size < bytes.size(); size += size < 1100 ? 1 : 13)
    EXPECT_THROW((void)map_from(bytes.substr(0, size), "x.mrc"), InputError);
}

TEST(MapFile, WithAnyWordOfItsHeaderChangedIsReadOrRefused) {
  const std::string bytes = map_bytes(skewed_map());
  int read = 0, refused = 0;
  for (const char change : {'\x00', '\x01', '\x7f', '\x80', '\xff'})
    for (std::size_t at = 0; at < 256; ++at)
      for (const std::size_t width : {1u, 4u}) {
        std::string changed = bytes;
        changed.replace(at, width, width, change);
        try {
          const DensityMap map = map_from(changed, "x.mrc");
          const DensityMap wider = blurred(map, 3.0);
          for (const float value : wider.values()) ASSERT_TRUE(std::isfinite(value));
          ++read;
        } catch (const InputError&) {
          ++refused;
        }
      }
  EXPECT_GT(read, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace pliant::density_map_test
