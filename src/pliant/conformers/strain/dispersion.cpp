// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/dispersion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant {
namespace {

constexpr double most_a_pair = 20.0;      // kcal/mol
constexpr double nearest_share = 0.25;    // of a squared distance: nearer pairs are as if there
constexpr double hydrogen_bonded = 0.49;  // share of the squared distance: O..H 2.2 Angstrom

struct UffAtom {
  std::uint8_t element;
  double distance;  ///< Angstrom
  double depth;     ///< kcal/mol
};

constexpr UffAtom uff[] = {{1, 2.886, 0.044},  {5, 4.083, 0.180},  {6, 3.851, 0.105},
                           {7, 3.660, 0.069},  {8, 3.500, 0.060},  {9, 3.364, 0.050},
                           {14, 4.295, 0.402}, {15, 4.147, 0.305}, {16, 4.035, 0.274},
                           {17, 3.947, 0.227}, {34, 4.205, 0.291}, {35, 4.189, 0.251},
                           {53, 4.500, 0.339}};
constexpr UffAtom uff_carbon = uff[2];

UffAtom uff_of(const Framework& framework, Joint atom) {
  if (framework.atoms() == nullptr) return uff_carbon;
  const std::uint8_t element = framework.atoms()->elements[atom];
  const auto* const found = std::ranges::find(uff, element, &UffAtom::element);
  return found == std::end(uff) ? uff_carbon : *found;
}

/// Atoms fewer bonds away.
std::vector<Joint> near_in_bonds(const BondChemistry& chemistry, Joint atom, int bonds_apart) {
  std::vector<Joint> found{atom};
  std::size_t begin = 0;
  for (int depth = 1; depth < bonds_apart; ++depth) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin)
      for (const Link& bond : chemistry.bonds_at(found[begin])) found.push_back(bond.node);
  }
  return found;
}

bool may_bond(const BondChemistry& chemistry, Joint a, Joint b) {
  return chemistry.is_hydrogen(a) && chemistry.donates(a) && chemistry.accepts(b);
}

}  // namespace

Dispersion::Dispersion(const Framework& framework, const BondChemistry& chemistry,
                       const DispersionOptions& options) {
  const double scale = options.scale * options.scale;
  const auto count = static_cast<Joint>(framework.joint_count());
  for (Joint a = 0; a < count; ++a) {
    const std::vector<Joint> near = near_in_bonds(chemistry, a, options.bonds_apart);
    const UffAtom one = uff_of(framework, a);
    for (Joint b = a + 1; b < count; ++b) {
      if (std::find(near.begin(), near.end(), b) != near.end()) continue;
      const UffAtom other = uff_of(framework, b);
      const bool bonds = may_bond(chemistry, a, b) || may_bond(chemistry, b, a);
      const double share = bonds ? hydrogen_bonded : 1.0;
      pairs_.push_back({a, b, scale * share * one.distance * other.distance,
                        std::sqrt(one.depth * other.depth)});
    }
  }
}

double Dispersion::energy(std::span<const Vec3> x) const {
  double sum = 0.0;
  for (const Pair& pair : pairs_) {
    const double q = pair.square / norm_squared(x[pair.a] - x[pair.b]);
    const double q3 = q * q * q, here = pair.depth * (q3 * q3 - 2.0 * q3);
    sum += here < most_a_pair ? here : most_a_pair;
  }
  return sum;
}

double Dispersion::add(std::span<const Vec3> x, std::span<Vec3> gradient) const {
  double sum = 0.0;
  for (const Pair& pair : pairs_) {
    const Vec3 apart = x[pair.a] - x[pair.b];
    const double square = std::max(norm_squared(apart), nearest_share * pair.square);
    const double q = pair.square / square, q3 = q * q * q;
    sum += pair.depth * (q3 * q3 - 2.0 * q3);
    const Vec3 pull = (-12.0 * pair.depth * (q3 * q3 - q3) / square) * apart;
    gradient[pair.a] += pull;
    gradient[pair.b] -= pull;
  }
  return sum;
}

}  // namespace pliant
