// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/torsion_draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pliant {
namespace torsion_draws_test {

constexpr double degree = std::numbers::pi / 180.0;

double degrees(Turn turn) {
  return std::fmod(std::atan2(turn.sine, turn.cosine) / degree + 360.0, 360.0);
}

Turn of(double angle) { return {std::cos(angle * degree), std::sin(angle * degree)}; }

/// From the nearest peak, in its widths.
double off_usual(double angle, const BondTurnEntry& row) {
  double least = 180.0;
  for (const TorsionPeak& peak : row.peaks)
    for (const double sign : {-1.0, 1.0})
      least =
          std::min(least, std::abs(std::remainder(angle - sign * peak.angle, 360.0)) / peak.width);
  return least;
}

TEST(TorsionDraws, TurnsAddUp) {
  EXPECT_NEAR(degrees(of(80) * of(300)), 20.0, 1e-9);
  EXPECT_NEAR(degrees(of(80) * back(of(30))), 50.0, 1e-9);
  EXPECT_NEAR(degrees(of_half_tangent(std::tan(35 * degree))), 70.0, 1e-9);
}

TEST(TorsionDraws, UsualOnesLieWhereTheTableSaysAndReachAllOfIt) {
  for (const BondTurnEntry& row : bond_turns()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(row.name, entry(row.kind).name);
    if (stays(row.kind)) continue;
    RandomSequence draws({.seed = 3});
    std::vector<int> seen(row.peaks.size());
    int usual = 0;
    for (int k = 0; k < 4000; ++k) {
      const double angle = degrees(drawn_usual(draws, row.kind));
      if (off_usual(angle, row) < 0.8) ++usual;
      for (std::size_t m = 0; m < seen.size(); ++m)
        if (off_usual(angle, {row.kind, row.name, row.peaks.subspan(m, 1)}) < 0.8) ++seen[m];
    }
    EXPECT_GT(usual, 3100);
    for (const int count : seen) EXPECT_GT(count, 0);
  }
}

TEST(TorsionDraws, EnergiesAreLowestAtPeaksAndRiseBetween) {
  for (const BondTurnEntry& row : bond_turns()) {
    SCOPED_TRACE(row.name);
    double lowest = 9.0;
    for (int angle = -180; angle < 180; ++angle) {
      const double energy = torsion_energy(row.kind, of(angle));
      lowest = std::min(lowest, energy);
      EXPECT_LT(energy, 6.5);
      EXPECT_NEAR(energy, torsion_energy(row.kind, of(-angle)), 1e-9);
      EXPECT_NEAR(energy, torsion_energy(row.kind, of(angle + 1)), 0.5);
    }
    EXPECT_NEAR(lowest, 0.0, 0.01);
  }
  EXPECT_NEAR(torsion_energy(BondTurn::alkyl, of(64)), 0.9, 0.02);
  EXPECT_GT(torsion_energy(BondTurn::biaryl_flanked, of(0)), 3.0);
  EXPECT_EQ(torsion_energy(BondTurn::any, of(17)), 0.0);
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
  EXPECT_NEAR(degrees(nearest_usual(of(80), BondTurn::alkyl)), 64.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(125), BondTurn::alkyl)), 180.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(299), BondTurn::biaryl_flanked)), 290.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(77), BondTurn::ester)), 77.0, 1e-9);
}

}  // namespace torsion_draws_test
}  // namespace pliant
