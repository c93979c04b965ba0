// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/strain.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/conformers/strain/torsion_gradient.hpp"

namespace pliant {
namespace {

// Usual stiffness of single bonds, and of angles at carbon (kcal/mol/Angstrom^2, kcal/mol).
constexpr double length_stiffness = 350.0, angle_stiffness = 50.0;
// Angles at rest are so because of atoms three bonds apart, and of others that are near: only what
// is much nearer counts.
constexpr double clash_scale = 0.85;
constexpr double planar = 10.0, bent = 0.5;  // kcal/mol: between two flat atoms, beside one
constexpr double amide = 40.0;               // in large rings: these are flattened

Bar ordered(Joint a, Joint b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

Strain::Strain(const Framework& framework, const BondChemistry& chemistry,
               std::span<const Vec3> rest, std::span<const Vec3> held)
    : dispersion_(framework, chemistry, {.bonds_apart = 4, .scale = clash_scale}) {
  for (Joint a = 0; a < framework.joint_count(); ++a) {
    find_angles(chemistry, a, rest);
    for (const Link& bond : chemistry.bonds_at(a)) {
      if (bond.node < a) continue;
      lengths_.push_back({a, bond.node, distance(rest[a], rest[bond.node])});
      find_torsions(chemistry, ordered(a, bond.node), held);
    }
  }
}

void Strain::find_angles(const BondChemistry& chemistry, Joint centre, std::span<const Vec3> rest) {
  const auto bonds = chemistry.bonds_at(centre);
  for (std::size_t k = 0; k < bonds.size(); ++k)
    for (std::size_t m = k + 1; m < bonds.size(); ++m) {
      const Vec3 one = rest[bonds[k].node] - rest[centre],
                 other = rest[bonds[m].node] - rest[centre];
      const double lengths = norm(one) * norm(other);
      angles_.push_back({bonds[k].node, centre, bonds[m].node, dot(one, other) / lengths,
                         norm(cross(one, other)) / lengths});
    }
}

/// The stiffness of a bond is shared among all of its torsions.
void Strain::find_torsions(const BondChemistry& chemistry, Bar bond, std::span<const Vec3> held) {
  const bool one = chemistry.is_tetrahedral(bond.a), other = chemistry.is_tetrahedral(bond.b);
  const auto paths =
      double((chemistry.bonds_at(bond.a).size() - 1) * (chemistry.bonds_at(bond.b).size() - 1));
  const bool is_amide = chemistry.is_ring_amide(bond.a, bond.b, false) ||
                        chemistry.is_ring_amide(bond.b, bond.a, false);
  if (!is_amide && one != other && chemistry.is_in_ring(bond.a) && chemistry.is_in_ring(bond.b))
    return;
  double whole = one && other ? half_threefold_barrier : (one || other ? bent : planar);
  if (is_amide) whole = amide;
  for (const Link& i : chemistry.bonds_at(bond.a))
    for (const Link& j : chemistry.bonds_at(bond.b)) {
      if (i.node == bond.b || j.node == bond.a || i.node == j.node) continue;
      const std::array<Joint, 4> at{i.node, bond.a, bond.b, j.node};
      const auto now = torsion_gradient(held[at[0]], held[at[1]], held[at[2]], held[at[3]]);
      if (!now) continue;
      const double cosine = is_amide ? std::copysign(1.0, now->cosine) : now->cosine;
      const double sine = is_amide ? 0.0 : now->sine;
      torsions_.push_back({at, cosine, sine, whole / paths, one && other});
    }
}

double Strain::at(std::span<const Vec3> x, std::span<Vec3> gradient) const {
  std::fill(gradient.begin(), gradient.end(), Vec3{});
  double sum = dispersion_.add(x, gradient);
  for (const Length& bond : lengths_) sum += add_length(bond, x, gradient);
  for (const Angle& angle : angles_) sum += add_angle(angle, x, gradient);
  for (const Torsion& torsion : torsions_) sum += add_torsion(torsion, x, gradient);
  return sum;
}

double Strain::add_length(const Length& bond, std::span<const Vec3> x,
                          std::span<Vec3> gradient) const {
  const Vec3 apart = x[bond.a] - x[bond.b];
  const double length = norm(apart), off = length - bond.rest;
  const Vec3 pull = (2.0 * length_stiffness * off / length) * apart;
  gradient[bond.a] += pull;
  gradient[bond.b] -= pull;
  return length_stiffness * off * off;
}

/// 2 k (1 - cos(angle - rest)), which is k (angle - rest)^2 for small ones.
double Strain::add_angle(const Angle& angle, std::span<const Vec3> x,
                         std::span<Vec3> gradient) const {
  const Vec3 one = x[angle.a] - x[angle.centre], other = x[angle.b] - x[angle.centre];
  const double length = norm(one), other_length = norm(other);
  const Vec3 u = (1.0 / length) * one, v = (1.0 / other_length) * other;
  const double cosine = dot(u, v), sine = std::max(norm(cross(u, v)), 1e-6);
  const double turn = 2.0 * angle_stiffness * (sine * angle.cosine - cosine * angle.sine);
  // d angle / d a = (cosine u - v) / (length sine)
  const Vec3 at_a = (turn / (length * sine)) * (cosine * u - v);
  const Vec3 at_b = (turn / (other_length * sine)) * (cosine * v - u);
  gradient[angle.a] += at_a;
  gradient[angle.b] += at_b;
  gradient[angle.centre] -= at_a + at_b;
  return 2.0 * angle_stiffness * (1.0 - cosine * angle.cosine - sine * angle.sine);
}

double Strain::add_torsion(const Torsion& torsion, std::span<const Vec3> x,
                           std::span<Vec3> gradient) const {
  const auto& at = torsion.at;
  const auto now = torsion_gradient(x[at[0]], x[at[1]], x[at[2]], x[at[3]]);
  if (!now) return 0.0;
  const double c = now->cosine, s = now->sine;
  const double cosine = torsion.is_threefold ? (3.0 - 4.0 * c * c) * c  // -cos(3 angle)
                                             : c * torsion.cosine + s * torsion.sine;
  const double slope =
      torsion.is_threefold ? -3.0 * (3.0 - 4.0 * s * s) * s : s * torsion.cosine - c * torsion.sine;
  for (std::size_t k = 0; k < 4; ++k)
    gradient[at[k]] += (torsion.stiffness * slope) * now->gradient[k];
  return torsion.stiffness * (1.0 - cosine);
}

}  // namespace pliant
