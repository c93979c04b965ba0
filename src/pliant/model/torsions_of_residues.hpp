// SPDX-License-Identifier: MIT
// The torsion preferences of amino acids: side chains staggered about bonds of tetrahedral atoms,
// phi and psi in the usual regions.
#pragma once

#include "pliant/framework/torsion_preferences.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Of a structure whose bonds are known. What is unusual there may stay as unusual as it is, so
/// that nothing pulls at the start. Glycine and proline have no preference for phi and psi.
TorsionPreferences torsions_of_residues(const Structure& structure);

}  // namespace pliant
