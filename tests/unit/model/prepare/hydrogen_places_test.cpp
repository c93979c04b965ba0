// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/hydrogen_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace hydrogen_places_test {

constexpr double degree = std::numbers::pi / 180.0;

double angle(Vec3 a, Vec3 b, Vec3 c) {
  return std::acos(dot(a - b, c - b) / (distance(a, b) * distance(c, b))) / degree;
}

/// Degrees, from 0 to 360.
double torsion(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 axis = (1.0 / distance(b, c)) * (c - b);
  const Vec3 one = cross(a - b, axis), other = cross(d - c, axis);
  const double turn = std::atan2(dot(cross(one, other), axis), dot(one, other)) / degree;
  return std::fmod(turn + 360.0, 360.0);
}

TEST(HydrogenPlaces, ASpinHasLengthAngleAndTorsion) {
  const Vec3 reference{1.1, 0.3, -0.2}, neighbour{0, 0.2, 0.5}, parent{-0.7, 1.4, 0.9};
  const Spin spin(reference, neighbour, parent);
  for (const auto& [at, degrees] : {std::pair(tetrahedral_angle, 109.5),
                                    std::pair(planar_angle, 120.0), std::pair(thiol_angle, 96.0)})
    for (int tens = 1; tens < 36; ++tens) {
      const Vec3 h = spin.at(1.09, at, tens);
      EXPECT_NEAR(distance(h, parent), 1.09, 1e-12);
      EXPECT_NEAR(angle(h, parent, neighbour), degrees, 1e-9);
      EXPECT_NEAR(torsion(reference, neighbour, parent, h), 10.0 * tens, 1e-9);
    }
}

TEST(HydrogenPlaces, CosinesOfTensAreCosines) {
  for (int tens = -40; tens < 80; ++tens)
    EXPECT_NEAR(cosine_of_tens(tens), std::cos(10.0 * tens * degree), 1e-14) << tens;
}

TEST(HydrogenPlaces, BetweenTwoBonds) {
  const Vec3 parent{1, 1, 1}, one{2.5, 1, 1}, other{1, 2.2, 1};
  const Vec3 back = against_both(parent, one, other, 1.01);
  EXPECT_NEAR(distance(back, parent), 1.01, 1e-12);
  EXPECT_NEAR(angle(back, parent, one), 135.0, 1e-9);
  EXPECT_NEAR(angle(back, parent, other), 135.0, 1e-9);
  const Vec3 up = out_of_plane(parent, one, other, 1.09, 1.0),
             down = out_of_plane(parent, one, other, 1.09, -1.0);
  EXPECT_NEAR(distance(up, parent), 1.09, 1e-12);
  EXPECT_NEAR(angle(up, parent, down), 109.5, 1e-9);
  EXPECT_GT(up.z, 1.0);
  EXPECT_NEAR(up.z + down.z, 2.0, 1e-12);
}

/// Bonds on one line, or of no length, have no direction across: some place is taken.
TEST(HydrogenPlaces, WithoutADirectionSomeIsTaken) {
  EXPECT_EQ(unit_vector({}), (Vec3{0, 0, 1}));
  for (Vec3 u : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6, 0, 0.8}}) {
    EXPECT_NEAR(dot(perpendicular_to(u), u), 0.0, 1e-15);
    EXPECT_NEAR(norm(perpendicular_to(u)), 1.0, 1e-15);
  }
  const Vec3 beside = against_both({}, {1, 0, 0}, {-1, 0, 0}, 2.0);
  EXPECT_NEAR(norm(beside), 2.0, 1e-12);
  EXPECT_NEAR(beside.x, 0.0, 1e-12);
  const Vec3 on_line = Spin({2, 0, 0}, {1, 0, 0}, {}).at(1.0, tetrahedral_angle, 0);
  EXPECT_NEAR(norm(on_line), 1.0, 1e-12);
}

}  // namespace hydrogen_places_test
}  // namespace pliant
