// SPDX-License-Identifier: MIT
// Rings and ring systems with several forms, and how a molecule is given one of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/rings/ring_forms.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// A ring or ring system, and the branches at each of its atoms.
struct FlexibleRing {
  std::vector<Joint> atoms;
  std::vector<std::vector<std::size_t>> neighbours;  ///< for each atom, indices into `atoms`
  std::vector<std::vector<Joint>> branches;
  std::vector<Bar> angles;      ///< pairs whose distances may change within limits
  std::vector<RingForm> forms;  ///< the form of the start is the first
};

/// Which rings are looked for besides those of five and six that share no bond with another.
struct RingsAsked {
  bool large = false;    ///< of seven and more
  bool systems = false;  ///< systems of small rings
};

/// All of these that are not planar at `start` (N, Angstrom). Does not check whether the forms
/// satisfy bars and limits of the framework.
std::vector<FlexibleRing> flexible_rings(const Framework& framework, const BondChemistry& chemistry,
                                         std::span<const Vec3> start, RingsAsked asked);

/// Pairs whose distance changes between the forms of rings with more than one form, and, if
/// `with_systems`, of ring systems.
std::vector<Bar> soft_pairs(const Framework& framework, const BondChemistry& chemistry,
                            std::span<const Vec3> start, bool with_systems);

/// Gives a ring of x (N) this form, superposed on its present one, and moves the branches with the
/// bonds of the ring at their atom.
void take_form(const FlexibleRing& ring, const RingForm& form, std::span<Vec3> x);

}  // namespace pliant
