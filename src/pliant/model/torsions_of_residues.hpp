// SPDX-License-Identifier: MIT
// Torsion preferences of amino acids: side chains staggered about bonds of tetrahedral atoms, phi
// and psi in the usual regions.
#pragma once

#include "pliant/framework/torsion_preferences.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The preferences of a structure whose bonds are known. Unusual torsions may remain as unusual as
/// they are, so that nothing pulls at the start. Glycine and proline have no preference for phi and
/// psi.
TorsionPreferences torsions_of_residues(const Structure& structure);

}  // namespace pliant
