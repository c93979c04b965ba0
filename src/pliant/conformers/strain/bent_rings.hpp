// SPDX-License-Identifier: MIT
// Forms of rings that bend bars: conformers of one start do not take them, further starts do.
#pragma once

#include <span>
#include <vector>

#include "pliant/conformers/rings/ring_moves.hpp"

namespace pliant {

/// Rings of a molecule with the forms that change bars of its conformers, by less than 0.3 of their
/// lengths, and leave bonds between flat atoms turned about as far as at `start` (N, Angstrom), to
/// either side: such as the mirror images of benzodiazepines.
std::vector<FlexibleRing> bent_rings(const Framework& molecule, const BondChemistry& chemistry,
                                     std::span<const Vec3> start);

}  // namespace pliant
