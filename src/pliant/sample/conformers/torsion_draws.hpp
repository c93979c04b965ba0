// SPDX-License-Identifier: MIT
// How torsions of bonds are drawn, by kind of bond: where they are usual in small molecules
// (C. Schaerfer et al., J. Med. Chem. 56 (2013) 2016; S. Riniker, G. A. Landrum, J. Chem. Inf.
// Model. 55 (2015) 2562), or anywhere.
#pragma once

#include <cstdint>
#include <string_view>

#include "pliant/base/random.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

/// How torsions are drawn.
enum class TorsionDraw : std::uint8_t {
  uniform,    ///< each from the whole circle
  preferred,  ///< near one that is usual for such a bond
};

/// What a bond that turns is like. Flat are aryl rings and planar nitrogen without hydrogen.
enum class BondTurn : std::uint8_t {
  any,            ///< nothing is known: multiples of 30 degrees
  staggered,      ///< between two sp3 atoms: 60, 180, 300
  ester,          ///< O=C-O-R: as it is (Z, unless the file has E)
  in_plane,       ///< aryl - O: 0, 180
  flanked,        ///< the same with neighbours on both sides: 0, 90, 180, 270
  near_plane,     ///< aryl - N, aryl - C=O: 0, 180 and 30 beside them
  off_plane,      ///< aryl - N with neighbours on both sides: all but 0 and 180
  flat_primary,   ///< flat - CH2R: 90, 270
  flat_branched,  ///< aryl - CHR2: 60, 120, 240, 300, hydrogen near the plane
  beside_acyl,    ///< O or N of ester or amide - sp3: 90, 180, 270
};

/// One row of the table of kinds.
struct BondTurnEntry {
  BondTurn kind;
  std::string_view name;
  std::uint16_t multiples;  ///< bit k: k times 30 degrees is usual
  double half_tangent;      ///< of half of how far torsions are from it, either way
};

const BondTurnEntry& entry(BondTurn kind);

/// What the bond a - b is like.
BondTurn turn_of(const BondChemistry& chemistry, Joint a, Joint b);
/// The same in a large ring, where O and N of esters and amides are told apart.
BondTurn turn_in_loop(const BondChemistry& chemistry, Joint a, Joint b);

/// cos and sin of an angle.
struct Turn {
  double cosine = 1.0, sine = 0.0;
};

/// The one angle after the other.
Turn operator*(Turn one, Turn other);
inline Turn back(Turn turn) { return {turn.cosine, -turn.sine}; }

/// Any angle, evenly.
Turn drawn_angle(RandomSequence& draws);
/// An angle about 0, within what the kind allows.
Turn drawn_jitter(RandomSequence& draws, BondTurn kind);
/// By an angle whose half has the tangent t.
Turn of_half_tangent(double t);
/// The usual torsion of a kind that is nearest to one; itself if there is none.
Turn nearest_usual(Turn torsion, BondTurn kind);
/// A usual torsion of a kind, which must not be `ester`.
Turn drawn_usual(RandomSequence& draws, BondTurn kind);
/// The same in a large ring: of torsions between sp3 atoms half are 180 degrees.
Turn drawn_in_loop(RandomSequence& draws, BondTurn kind);

}  // namespace pliant
