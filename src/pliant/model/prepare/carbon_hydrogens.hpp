// SPDX-License-Identifier: MIT
// Places hydrogens on carbon by rule: ideal angles, staggered methyls, 1.09 Angstrom from sp3
// carbon, 1.08 from sp2. Deterministic on every machine.
#pragma once

#include <vector>

#include "pliant/model/prepare/polar_hydrogens.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The hydrogens on carbon that amino acids, caps and nucleotides of `structure` lack, in the order
/// of their parents. Carbons with a hydrogen, or with a missing heavy neighbour, get none; nor do
/// ligands and unusual residues, for which there is no rule. Linear in the number of atoms.
std::vector<PlacedHydrogen> place_carbon_hydrogens(const Structure& structure);

}  // namespace pliant
