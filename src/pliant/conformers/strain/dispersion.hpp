// SPDX-License-Identifier: MIT
// Energy of atoms that no bar holds apart: Lennard-Jones, with the distances and depths of UFF (A.
// K. Rappe et al., J. Am. Chem. Soc. 114 (1992) 10024). Without charges: alone in a vacuum they
// would fold molecules up.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

struct DispersionOptions {
  int bonds_apart = 3;  ///< pairs of atoms that are so many bonds apart, and more
  double scale = 1.0;   ///< of distances of least energy
};

class Dispersion {
 public:
  /// Atoms of unknown elements are taken as carbon.
  Dispersion(const Framework& framework, const BondChemistry& chemistry,
             const DispersionOptions& options);

  /// kcal/mol at `x` (N, Angstrom). No pair counts more than 20.
  double energy(std::span<const Vec3> x) const;
  /// The same without that bound, and adds its gradient (kcal/mol/Angstrom) to `gradient` (N).
  double add(std::span<const Vec3> x, std::span<Vec3> gradient) const;

 private:
  struct Pair {
    Joint a, b;
    double square;  ///< of the distance of least energy, Angstrom^2
    double depth;   ///< kcal/mol
  };
  std::vector<Pair> pairs_;
};

}  // namespace pliant
