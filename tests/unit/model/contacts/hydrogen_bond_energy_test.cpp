// SPDX-License-Identifier: MIT
// Energies worked out by hand where cos^2 and the wells are simple numbers.
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace hydrogen_bond_energy_test {

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr auto sp2 = Hybridisation::sp2, sp3 = Hybridisation::sp3;

double energy(Hybridisation donor, Hybridisation acceptor, double theta, double phi,
              double gamma = 180.0, double apart = 2.8) {
  return hydrogen_bond_energy(
      {apart, theta * degree, phi * degree, gamma * degree, donor, acceptor});
}

// theta of 120 degrees: cos^2 = 1/4, and e^-(pi/3)^6.
const double bent = 0.25 * std::exp(-std::pow(pi / 3.0, 6));

TEST(HydrogenBondEnergy, IsDeepestAtTheBestPlace) {
  EXPECT_NEAR(energy(sp3, sp3, 180.0, 109.5), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 180.0, 180.0), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 180.0, 180.0), -8.0, 1e-12);
}

TEST(HydrogenBondEnergy, FollowsTheFourCases) {
  EXPECT_NEAR(energy(sp3, sp3, 120.0, 169.5), -8.0 * bent * 0.25, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 120.0, 120.0), -8.0 * bent * 0.25, 1e-12);
  EXPECT_NEAR(energy(sp2, sp3, 120.0, 90.0), -8.0 * bent * bent, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 120.0, 150.0, 135.0), -8.0 * bent * 0.75, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 120.0, 120.0, 135.0), -8.0 * bent * 0.5, 1e-12);
}

TEST(HydrogenBondEnergy, FallsOffWithDistance) {
  // q = 2.8 / 5.6 = 1/2: 5 / 4096 - 6 / 1024 = -19 / 4096
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0, 180.0, 5.6), -8.0 * 19.0 / 4096.0, 1e-12);
}

TEST(HydrogenBondEnergy, OfABondThatIsTooShortIsNotRepulsive) {
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0, 180.0, 2.4), -4.0, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 180.0, 120.0, 180.0, 2.4), -1.0, 1e-12);
  EXPECT_EQ(energy(sp2, sp3, 180.0, 90.0, 180.0, 2.2), 0.0);
}

TEST(HydrogenBondEnergy, OfNonsenseIsNone) {
  EXPECT_EQ(energy(sp2, sp3, 180.0, 90.0, 180.0, std::nan("")), 0.0);
  EXPECT_EQ(salt_bridge_energy(std::nan("")), 0.0);
}

TEST(SaltBridgeEnergy, IsAWellOfTen) {
  EXPECT_NEAR(salt_bridge_energy(2.825), -10.0, 1e-12);
  EXPECT_NEAR(salt_bridge_energy(6.4 - 0.375), -10.0 * 19.0 / 4096.0, 1e-12);
  EXPECT_EQ(salt_bridge_energy(2.3), -8.0);
  EXPECT_EQ(salt_bridge_energy(2.1), 0.0);
}

}  // namespace hydrogen_bond_energy_test
}  // namespace pliant
