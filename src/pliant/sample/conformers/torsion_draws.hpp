// SPDX-License-Identifier: MIT
// Draws torsions of bonds: uniformly, or, by kind of bond, near those that are usual in small
// molecules (C. Schaerfer et al., J. Med. Chem. 56 (2013) 2016; S. Riniker, G. A. Landrum, J. Chem.
// Inf. Model. 55 (2015) 2562).
#pragma once

#include <cstdint>
#include <string_view>

#include "pliant/base/random.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

/// How torsions are drawn.
enum class TorsionDraw : std::uint8_t {
  uniform,    ///< each from the whole circle
  preferred,  ///< near a usual one for this kind of bond
};

/// Kinds of bonds that turn, with their usual torsions in degrees. Flat groups are aryl rings and
/// planar nitrogen without hydrogen.
enum class BondTurn : std::uint8_t {
  any,            ///< unknown: multiples of 30
  staggered,      ///< between two sp3 atoms: 60, 180, 300
  ester,          ///< O=C-O-R: as in the structure (Z, unless the file has E)
  in_plane,       ///< aryl - O: 0, 180
  flanked,        ///< aryl - O with neighbours on both sides: 0, 90, 180, 270
  near_plane,     ///< aryl - N, aryl - C=O: 0, 180 and 30 from these
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
  double half_tangent;      ///< tangent of half of the largest deviation
};

const BondTurnEntry& entry(BondTurn kind);

/// The kind of the bond a - b.
BondTurn turn_of(const BondChemistry& chemistry, Joint a, Joint b);
/// Its kind in a large ring, where esters differ from amides.
BondTurn turn_in_loop(const BondChemistry& chemistry, Joint a, Joint b);

/// cos and sin of an angle.
struct Turn {
  double cosine = 1.0, sine = 0.0;
};

/// The sum of two angles.
Turn operator*(Turn one, Turn other);
inline Turn back(Turn turn) { return {turn.cosine, -turn.sine}; }

/// A uniformly distributed angle.
Turn drawn_angle(RandomSequence& draws);
/// A random deviation that the kind allows.
Turn drawn_jitter(RandomSequence& draws, BondTurn kind);
/// The angle whose half has the tangent t.
Turn of_half_tangent(double t);
/// The usual torsion of a kind that is nearest to `torsion`; `torsion` itself if there is none.
Turn nearest_usual(Turn torsion, BondTurn kind);
/// A random usual torsion of a kind other than `ester`.
Turn drawn_usual(RandomSequence& draws, BondTurn kind);
/// The same in a large ring, where half of the torsions between sp3 atoms are 180 degrees.
Turn drawn_in_loop(RandomSequence& draws, BondTurn kind);

}  // namespace pliant
