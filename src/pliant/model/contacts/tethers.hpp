// SPDX-License-Identifier: MIT
// Hydrophobic tethers: C and S whose neighbours are C, S and H only, in residues that are two or
// more apart, nearer than the sum of their van der Waals radii (C 1.7, S 1.8 Angstrom) + 0.5. Held
// below max(start, sum) + 0.5 Angstrom, as FIRST and FRODA do (Hespenheide et al., J. Phys.
// Condens. Matter 16 (2004) S5055; they take 0.25).
#pragma once

#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/contact_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The tethers of a structure whose bonds are known. Sorted; linear in the number of atoms.
std::vector<MolecularContact> hydrophobic_tethers(const Structure& structure,
                                                  const TetherOptions& options = {});

/// What holds metals: N, O, S, Se, halogens and C in reach of one (coordination_reach), but for the
/// complex, as haem is one, that the metal is bonded in.
std::vector<MolecularContact> metal_contacts(const Structure& structure);

}  // namespace pliant
