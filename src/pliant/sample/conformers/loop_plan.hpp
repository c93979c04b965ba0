// SPDX-License-Identifier: MIT
// What turns in flexible loops (large rings) of a molecule: hinges of the plan's tree, torsions
// round the loops, and the gaps at which loops were cut.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"
#include "pliant/sample/conformers/torsion_draws.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

/// A hinge of a loop, and the places that turn with it.
struct LoopHinge {
  Slot a, b;         ///< on its axis
  Slot first, last;  ///< [first, last) turn
  bool turns(Slot place) const { return place >= first && place < last; }
};

/// A torsion about a bond of a loop. Of a bond that was cut its four places are on both sides.
struct LoopTorsion {
  std::array<Slot, 4> at;
  BondTurn kind;
  std::int64_t hinge;  ///< which turns it alone, -1: none
  bool is_forward;     ///< whether the hinge turns the last place, and not the first
};

/// Whether two atoms may make a hydrogen bond, as what.
enum class HydrogenBond : std::uint8_t {
  none,
  to_hydrogen,  ///< hydrogen of N or O, and O or N
  beside_it,    ///< N or O that bears hydrogen, and O or N
};

/// Two joints whose distance loops change, but no rotor does, and how near they may come.
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

/// `is_in_loop`: of each body. `is_rotor`: of each body, whether its hinge is drawn by itself. Of
/// loops that have other joints than hinges the plan has no hinges: they cannot be drawn.
LoopPlan plan_loops(const Framework& framework, const BodyPlan& plan,
                    const BondChemistry& chemistry, const std::vector<bool>& is_in_loop,
                    const std::vector<bool>& is_rotor);

}  // namespace pliant
