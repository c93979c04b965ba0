// SPDX-License-Identifier: MIT
// Places polar hydrogens (on N, O and S) by rule. Deterministic on every machine.
//
// N-H between two heavy neighbours lies on the bisector, 1.01 Angstrom from N; NH2 of amides,
// guanidinium and bases lie in the plane at 120 degrees. O-H (0.96 Angstrom) and N-H3 are at 109.5
// degrees, S-H (1.34) at 96 degrees; their torsion is scanned in steps of 10 degrees for the lowest
//   E(phi) = 0.02 cos(3 phi) - sum over O nearer than 2.7 Angstrom to H of
//            cos^2(X-H..O) exp(-(d(H..O) - 1.8)^2 / 0.3)
// with -0.02 cos(2 phi) as the first term if the bond keeps H in a plane (Tyr, COOH).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/prepare/protonation.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A hydrogen and the atom that it is bonded to.
struct PlacedHydrogen {
  std::uint32_t parent;
  std::string name;
  Vec3 position;
};

/// The polar hydrogens that amino acids and nucleotides of `structure` lack, in the order of their
/// parents. A backbone or side chain that has some hydrogen gets no more, except side chains whose
/// form was asked for. Chains begin with NH3, after chain breaks with NH. Linear in the number of
/// atoms.
std::vector<PlacedHydrogen> place_polar_hydrogens(const Structure& structure,
                                                  const Protonation& protonation);

/// Whether an atom of an amino acid belongs to its backbone: N, CA, C, O, OXT.
bool is_backbone(const std::string& name);

}  // namespace pliant
