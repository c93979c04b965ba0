// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double square(double x) { return x * x; }

/// 5 q^12 - 6 q^10, lowest at q = 1 where it is -1.
double well(double q) {
  const double q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
  return 5.0 * q8 * q4 - 6.0 * q8 * q2;
}

double angular_factor(const HydrogenBondGeometry& g) {
  const double bend = square(std::numbers::pi - g.theta);
  const double c = square(exact_bits_cos(g.theta)) * exact_bits_exp(-bend * bend * bend);
  if (g.donor == Hybridisation::sp2 && g.acceptor == Hybridisation::sp2)
    return c * square(exact_bits_cos(std::max(g.phi, g.gamma)));
  if (g.donor == Hybridisation::sp2) return c * c;
  if (g.acceptor == Hybridisation::sp2) return c * square(exact_bits_cos(g.phi));
  return c * square(exact_bits_cos(g.phi - 109.5 * degree));
}

}  // namespace

double hydrogen_bond_energy(const HydrogenBondGeometry& geometry) {
  constexpr double depth = 8.0, best = 2.8, too_short_depth = -4.0, shortest = 2.3;
  if (!(geometry.donor_acceptor > shortest)) return 0.0;
  const double radial = depth * well(best / geometry.donor_acceptor);
  return (radial > 0.0 ? too_short_depth : radial) * angular_factor(geometry);
}

double salt_bridge_energy(double donor_acceptor) {
  constexpr double depth = 10.0, best = 3.2, offset = 0.375, too_short = -8.0, shortest = 2.2;
  if (!(donor_acceptor > shortest)) return 0.0;
  const double energy = depth * well(best / (donor_acceptor + offset));
  return energy > 0.0 ? too_short : energy;
}

}  // namespace pliant
