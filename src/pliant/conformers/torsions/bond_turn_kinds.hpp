// SPDX-License-Identifier: MIT
// Which kind a bond that turns is of (bond_turns.hpp), by the elements and planes around it.
#pragma once

#include <array>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/torsions/bond_turns.hpp"

namespace pliant {

/// The kind of the bond a - b. Its torsion is that of BondChemistry::reference() on both sides.
BondTurn turn_of(const BondChemistry& chemistry, Joint a, Joint b);
/// Axes of atropisomers, in no ring, as torsions with the references of both sides; by the lower
/// atom of the bond.
std::vector<std::array<Joint, 4>> atropisomer_axes(const BondChemistry& chemistry);
/// Its kind in a large ring.
BondTurn turn_in_loop(const BondChemistry& chemistry, Joint a, Joint b);

}  // namespace pliant
