// SPDX-License-Identifier: MIT
// Hydrogens on carbon placed by rule: ideal angles, methyls staggered; the same each time, on every
// machine. 1.09 Angstrom from sp3 carbon, 1.08 from sp2.
#pragma once

#include <vector>

#include "pliant/model/prepare/polar_hydrogens.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The hydrogens on carbon that amino acids, caps and nucleotides of `structure` lack, in the order
/// of their parents. A carbon that has a hydrogen is left as it is, and so is one whose heavy
/// neighbours are not all there. Ligands and unusual residues get none: there is no rule for them.
/// Linear in the number of atoms.
std::vector<PlacedHydrogen> place_carbon_hydrogens(const Structure& structure);

}  // namespace pliant
