// SPDX-License-Identifier: MIT
// Polar hydrogens (on N, O and S) placed by rule: the same each time, on every machine.
//
// N-H between two heavy neighbours lies on the bisector, 1.01 Angstrom from N; NH2 of amides,
// guanidinium and bases lie in the plane at 120 degrees. O-H (0.96 Angstrom), NH3 and the N of a
// chain's begin at 109.5 degrees, S-H (1.34) at 96 degrees; their torsion is scanned in steps of 10
// degrees for the lowest
//   E(phi) = 0.02 cos(3 phi) - sum over acceptors O nearer than 2.7 Angstrom to H of
//            cos^2(X-H..O) exp(-(d(H..O) - 1.8)^2 / 0.3),     cos(2 phi + 180) on aromatic rings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A hydrogen and the atom that it is bonded to.
struct PlacedHydrogen {
  std::uint32_t parent;
  std::string name;
  Vec3 position;
};

/// The polar hydrogens that amino acids and nucleotides of `structure` lack, in the order of their
/// parents. `forms` (R) are those of protonation_of(). The backbone and the side chain of a residue
/// that have a hydrogen are left as they are. Linear in the number of atoms.
std::vector<PlacedHydrogen> place_polar_hydrogens(const Structure& structure,
                                                  const std::vector<std::string>& forms);

}  // namespace pliant
