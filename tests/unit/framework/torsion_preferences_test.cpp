// SPDX-License-Identifier: MIT
#include "pliant/framework/torsion_preferences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/error.hpp"
#include "pliant/base/random.hpp"

namespace pliant {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

/// Blondel and Karplus, J. Comput. Chem. 17 (1996) 1132, with the C library's arctan.
double by_arctan(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 f = a - b, g = b - c, h = d - c;
  const Vec3 one = cross(f, g), other = cross(h, g);
  return std::atan2(dot(cross(other, one), g) / norm(g), dot(one, other));
}

TEST(TorsionPreferences, TorsionIsThatOfArctan) {
  RandomSequence draws({7, Domain::displacement, 0, 0, 0});
  for (int k = 0; k < 1000; ++k) {
    const Vec3 a = draws.direction(), b = draws.direction(), c = draws.direction(),
               d = draws.direction();
    EXPECT_NEAR(torsion_angle(a, b, c, d), by_arctan(a, b, c, d), 1e-12);
  }
}

TEST(TorsionPreferences, TorsionOfALineIsZero) {
  EXPECT_EQ(torsion_angle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}), 0.0);
}

TEST(TorsionPreferences, OffStaggeredIsTheNearestOfThree) {
  for (int turn = -180; turn <= 180; ++turn) {
    double nearest = 360.0;
    for (const double well : {-180.0, -60.0, 60.0, 180.0})
      if (std::abs(turn - well) < std::abs(nearest)) nearest = turn - well;
    EXPECT_NEAR(std::abs(off_staggered(turn * degrees)), std::abs(nearest) * degrees, 1e-12)
        << turn;
    EXPECT_LE(std::abs(off_staggered(turn * degrees)), 60.0 * degrees + 1e-12);
  }
  EXPECT_NEAR(off_staggered(70.0 * degrees), 10.0 * degrees, 1e-12);
  EXPECT_NEAR(off_staggered(-170.0 * degrees), 10.0 * degrees, 1e-12);
}

TEST(TorsionPreferences, UsualPlacesOfTheBackboneAreInside) {
  for (const auto& [phi, psi] : {std::pair{-63.0, -43.0},
                                 {-120.0, 130.0},
                                 {-75.0, 145.0},
                                 {-140.0, 165.0},
                                 {-90.0, 0.0},
                                 {57.0, 40.0},
                                 {-120.0, -175.0}})
    EXPECT_LT(backbone_reach(phi * degrees, psi * degrees), 1.0) << phi << ", " << psi;
  for (const auto& [phi, psi] : {std::pair{0.0, 0.0},
                                 {60.0, -100.0},
                                 {-20.0, 100.0},
                                 {150.0, 60.0},
                                 {-100.0, -110.0},
                                 {100.0, 90.0}})
    EXPECT_GT(backbone_reach(phi * degrees, psi * degrees), 1.1) << phi << ", " << psi;
}

TEST(TorsionPreferences, BackboneTurnsToTheEdgeOfTheNearestRegion) {
  for (double phi = -180.0; phi < 180.0; phi += 7.0)
    for (double psi = -180.0; psi < 180.0; psi += 7.0) {
      const double x = phi * degrees, y = psi * degrees, here = backbone_reach(x, y);
      const BackboneTurn turn = backbone_turn(x, y, 1.2);
      if (here <= 1.2) {
        EXPECT_EQ(turn.phi, 0.0);
        EXPECT_EQ(turn.psi, 0.0);
      } else {
        // Regions overlap: on the way to the edge of one it may come into another.
        EXPECT_LE(backbone_reach(x + turn.phi, y + turn.psi), 1.2 + 1e-9) << phi << ", " << psi;
        EXPECT_LT(backbone_reach(x + 0.5 * turn.phi, y + 0.5 * turn.psi), here);
      }
    }
}

TEST(TorsionPreferences, BadOnesAreRefused) {
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 4}, 0.3}}}, 4), InputError);
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 0}, 0.3}}}, 4), InputError);
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 3}, 2.0}}}, 4), InputError);
  EXPECT_THROW(check({.backbone = {{{0, 1, 2, 3, 4}, 0.0}}}, 5), InputError);
  EXPECT_NO_THROW(check({.staggered = {{{0, 1, 2, 3}, 0.3}}}, 4));
}

}  // namespace
}  // namespace pliant
