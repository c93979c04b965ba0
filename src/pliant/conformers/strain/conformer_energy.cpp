// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/conformer_energy.hpp"

#include <algorithm>

#include "pliant/conformers/strain/torsion_gradient.hpp"
#include "pliant/conformers/torsions/bond_turn_kinds.hpp"

namespace pliant {
namespace {

// With angles that cannot open, atoms seem nearer than they are, and in vacuum molecules fold up.
constexpr double scale_of_reach = 0.8, dispersion_share = 0.5;
constexpr std::size_t most_members = 7;

}  // namespace

ConformerEnergy::ConformerEnergy(const Framework& framework, const BondChemistry& chemistry)
    : dispersion_(framework, chemistry, {.scale = scale_of_reach}) {
  if (framework.atoms() == nullptr) return;
  for (Joint a = 0; a < framework.joint_count(); ++a)
    for (const Link& bond : chemistry.bonds_at(a)) {
      if (bond.node < a) continue;
      if (!chemistry.is_in_ring_up_to(most_members, a, bond.node))
        find_usual_torsion(chemistry, {a, bond.node});
      else if (chemistry.is_tetrahedral(a) && chemistry.is_tetrahedral(bond.node))
        find_ring_torsions(chemistry, {a, bond.node});
    }
}

void ConformerEnergy::find_usual_torsion(const BondChemistry& chemistry, Bar bond) {
  const Joint one = chemistry.reference(bond.a, bond.b),
              other = chemistry.reference(bond.b, bond.a);
  if (one == bond.a || other == bond.b) return;
  usual_.push_back({{one, bond.a, bond.b, other}, turn_of(chemistry, bond.a, bond.b)});
}

void ConformerEnergy::find_ring_torsions(const BondChemistry& chemistry, Bar bond) {
  const auto one = chemistry.bonds_at(bond.a), other = chemistry.bonds_at(bond.b);
  const double share = half_threefold_barrier / double((one.size() - 1) * (other.size() - 1));
  for (const Link& i : one)
    for (const Link& j : other)
      if (i.node != bond.b && j.node != bond.a && i.node != j.node)
        in_rings_.push_back({{i.node, bond.a, bond.b, j.node}, share});
}

double ConformerEnergy::at(std::span<const Vec3> x) const {
  const auto torsion_at = [&](const std::array<Joint, 4>& at) {
    return torsion_gradient(x[at[0]], x[at[1]], x[at[2]], x[at[3]]);
  };
  double sum = dispersion_share * dispersion_.energy(x);
  for (const UsualTorsion& torsion : usual_)
    if (const auto now = torsion_at(torsion.at))
      sum += torsion_energy(torsion.kind, Turn{now->cosine, now->sine});
  for (const RingTorsion& torsion : in_rings_)
    if (const auto now = torsion_at(torsion.at)) {
      const double c = now->cosine;
      sum += torsion.stiffness * (1.0 + (4.0 * c * c - 3.0) * c);
    }
  return sum;
}

}  // namespace pliant
