// SPDX-License-Identifier: MIT
// Moving parts of flexible loops (large rings): hinges of the plan's tree, torsions round the
// loops, and the gaps at which loops were cut.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// A hinge of a loop, and the places that it turns.
struct LoopHinge {
  Slot a, b;         ///< on its axis
  Slot first, last;  ///< [first, last) turn
  bool turns(Slot place) const { return place >= first && place < last; }
};

/// A torsion about a bond of a loop. At a bond that was cut its four places are on both sides.
struct LoopTorsion {
  std::array<Slot, 4> at;
  BondTurn kind;
  std::int64_t hinge;  ///< the only hinge that turns it, -1: none
  bool is_forward;     ///< whether the hinge turns the last place (not the first)
};

/// Whether, and how, two atoms may take part in a hydrogen bond.
enum class HydrogenBond : std::uint8_t {
  none,
  to_hydrogen,  ///< hydrogen of N or O, and O or N
  beside_it,    ///< N or O that bears hydrogen, and O or N
};

/// Two joints whose distance changes with loops, but with no rotor, and their least distance.
struct LoopPair {
  Slot i, j;
  double least;  ///< Angstrom
  HydrogenBond bond;
};

struct LoopPlan {
  std::vector<LoopHinge> hinges;  ///< parents first
  std::vector<LoopTorsion> torsions;
  std::vector<LoopPair> pairs;
};

/// `is_in_loop`: for each body. `is_rotor`: for each body whether its hinge is drawn separately.
/// Without hinges for loops with joints other than hinges: they cannot be drawn.
LoopPlan plan_loops(const Framework& framework, const BodyPlan& plan,
                    const BondChemistry& chemistry, const std::vector<bool>& is_in_loop,
                    const std::vector<bool>& is_rotor);

}  // namespace pliant
