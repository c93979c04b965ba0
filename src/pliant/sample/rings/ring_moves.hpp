// SPDX-License-Identifier: MIT
// Rings and ring systems that have several forms, and how a molecule is given one of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"
#include "pliant/sample/rings/ring_forms.hpp"

namespace pliant {

/// A ring or ring system, and what hangs on each of its atoms.
struct FlexibleRing {
  std::vector<Joint> atoms;
  std::vector<std::vector<std::size_t>> neighbours;  ///< of each atom, places in `atoms`
  std::vector<std::vector<Joint>> branches;
  std::vector<Bar> angles;      ///< pairs that its forms may change, within limits
  std::vector<RingForm> forms;  ///< the first is that of the start
};

/// All that do not lie in a plane at `start` (N, Angstrom): rings that share no bond with another,
/// those of seven and more only if `with_large`, and systems of small rings. Whether they hold bars
/// and limits of the framework is not looked at.
std::vector<FlexibleRing> flexible_rings(const Framework& framework, const BondChemistry& chemistry,
                                         std::span<const Vec3> start, bool with_large);

/// Pairs whose distance the forms of rings change, of all rings that `flexible_rings` gives more
/// than one form.
std::vector<Bar> soft_pairs(const Framework& framework, const BondChemistry& chemistry,
                            std::span<const Vec3> start);

/// Gives a ring of x (N) this form, superposed on the one it has, its branches moved as the bonds
/// of the ring at their atom are.
void take_form(const FlexibleRing& ring, const RingForm& form, std::span<Vec3> x);

}  // namespace pliant
