// SPDX-License-Identifier: MIT
// Our own energy of conformers of one molecule, for ranking them: torsions that are usual for their
// kind of bond, rings staggered, atoms apart (dispersion.hpp). Lengths and angles do not count.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/conformers/strain/dispersion.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"

namespace pliant {

class ConformerEnergy {
 public:
  ConformerEnergy(const Framework& framework, const BondChemistry& chemistry);

  /// kcal/mol, of `x` (N, Angstrom). Energies of different molecules cannot be compared.
  double at(std::span<const Vec3> x) const;

 private:
  /// A bond outside of small rings.
  struct UsualTorsion {
    std::array<Joint, 4> at;
    BondTurn kind;
  };
  struct RingTorsion {
    std::array<Joint, 4> at;
    double stiffness;  ///< kcal/mol
  };
  void find_usual_torsion(const BondChemistry& chemistry, Bar bond);
  void find_ring_torsions(const BondChemistry& chemistry, Bar bond);

  std::vector<UsualTorsion> usual_;
  std::vector<RingTorsion> in_rings_;
  Dispersion dispersion_;
};

}  // namespace pliant
