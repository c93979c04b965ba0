// SPDX-License-Identifier: MIT
#include "pliant/sample/conformers/torsion_draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace torsion_draws_test {

constexpr double degree = std::numbers::pi / 180.0;

double degrees(Turn turn) {
  return std::fmod(std::atan2(turn.sine, turn.cosine) / degree + 360.0, 360.0);
}

Turn of(double angle) { return {std::cos(angle * degree), std::sin(angle * degree)}; }

/// From the nearest multiple of 30 degrees of a kind that is usual.
double off_usual(double angle, const BondTurnEntry& row) {
  double least = 180.0;
  for (int k = 0; k < 12; ++k)
    if ((row.multiples >> k & 1) != 0)
      least = std::min(least, std::abs(std::remainder(angle - 30.0 * k, 360.0)));
  return least;
}

TEST(TorsionDraws, TurnsAddUp) {
  EXPECT_NEAR(degrees(of(80) * of(300)), 20.0, 1e-9);
  EXPECT_NEAR(degrees(of(80) * back(of(30))), 50.0, 1e-9);
  EXPECT_NEAR(degrees(of_half_tangent(std::tan(35 * degree))), 70.0, 1e-9);
}

TEST(TorsionDraws, UsualOnesLieWhereTheTableSaysAndReachAllOfIt) {
  for (const BondTurn kind :
       {BondTurn::any, BondTurn::staggered, BondTurn::in_plane, BondTurn::flanked,
        BondTurn::near_plane, BondTurn::off_plane, BondTurn::flat_primary, BondTurn::flat_branched,
        BondTurn::beside_acyl}) {
    const BondTurnEntry& row = entry(kind);
    SCOPED_TRACE(row.name);
    const double reach = 2.0 * std::atan(row.half_tangent) / degree;
    RandomSequence draws({.seed = 3});
    double furthest = 0.0;
    std::uint16_t seen = 0;
    for (int k = 0; k < 400; ++k) {
      const double angle = degrees(drawn_usual(draws, kind));
      furthest = std::max(furthest, off_usual(angle, row));
      seen = static_cast<std::uint16_t>(seen | 1u << std::lround(angle / 30.0) % 12);
    }
    EXPECT_LE(furthest, reach + 1e-9);
    EXPECT_GT(furthest, 0.9 * std::min(reach, 15.0));
    EXPECT_EQ(seen & row.multiples, row.multiples);
  }
}

TEST(TorsionDraws, AnglesAreAnyEvenly) {
  RandomSequence draws({.seed = 4});
  int quarters[4] = {};
  for (int k = 0; k < 4000; ++k) {
    const Turn turn = drawn_angle(draws);
    EXPECT_NEAR(turn.cosine * turn.cosine + turn.sine * turn.sine, 1.0, 1e-12);
    ++quarters[static_cast<int>(degrees(turn) / 90.0) % 4];
  }
  for (int quarter : quarters) EXPECT_NEAR(quarter, 1000, 5 * std::sqrt(750.0));
}

TEST(TorsionDraws, TheNearestUsualOne) {
  EXPECT_NEAR(degrees(nearest_usual(of(75), BondTurn::staggered)), 60.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(121), BondTurn::staggered)), 180.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(359), BondTurn::flat_primary)), 270.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(77), BondTurn::ester)), 77.0, 1e-9);
}

/// Of torsions between sp3 atoms in large rings half are 180 degrees.
TEST(TorsionDraws, LargeRingsAreWide) {
  RandomSequence draws({.seed = 5});
  int wide = 0;
  for (int k = 0; k < 2000; ++k)
    wide += std::abs(degrees(drawn_in_loop(draws, BondTurn::staggered)) - 180.0) < 30.0 ? 1 : 0;
  EXPECT_NEAR(wide, 1000, 5 * std::sqrt(500.0));
}

}  // namespace torsion_draws_test
}  // namespace pliant
