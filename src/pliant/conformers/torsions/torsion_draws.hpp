// SPDX-License-Identifier: MIT
// Draws torsions of bonds: uniformly, or, by kind of bond, near those that are usual in small
// molecules, and says how much energy a torsion costs.
#pragma once

#include <cstdint>

#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/bond_turns.hpp"

namespace pliant {

/// How torsions are drawn.
enum class TorsionDraw : std::uint8_t {
  uniform,    ///< each from the whole circle
  preferred,  ///< near a usual one for this kind of bond
};

/// cos and sin of an angle.
struct Turn {
  double cosine = 1.0, sine = 0.0;
};

/// The sum of two angles.
Turn operator*(Turn one, Turn other);
inline Turn back(Turn turn) { return {turn.cosine, -turn.sine}; }

/// A uniformly distributed angle.
Turn drawn_angle(RandomSequence& draws);
/// A random deviation of up to 12 degrees.
Turn drawn_jitter(RandomSequence& draws);
/// The angle whose half has the tangent t.
Turn of_half_tangent(double t);
/// The usual torsion of a kind that is nearest to `torsion`; `torsion` itself if there is none.
Turn nearest_usual(Turn torsion, BondTurn kind);
/// A random torsion of a kind other than `ester`: one of its peaks, with probability exp(-E / 0.6
/// kcal/mol), and a deviation of up to 0.8 widths; one of five is any angle.
Turn drawn_usual(RandomSequence& draws, BondTurn kind);

/// The energy of a torsion in kcal/mol, smooth, the lowest of its kind 0, at most about 5: -RT ln
/// of the sum of the peaks, each with weight exp(-E / RT) and its width (von Mises). 0 for kinds
/// `any` and `ester`. The torsion is that of BondChemistry::reference() on both sides, as of a
/// Rotor.
double torsion_energy(BondTurn kind, Turn torsion);

}  // namespace pliant
