// SPDX-License-Identifier: MIT
// The forms of a ring with given lengths and angles: chairs and twist-boats of six atoms, and the
// mirror image of any ring.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// One form of a ring.
struct RingForm {
  std::vector<Vec3> positions;  ///< (n) Angstrom, at an arbitrary place
  bool is_chair = false;        ///< a ring of six with torsions of alternating signs
};

/// Whether it is a ring of six with torsions of alternating signs.
bool is_chair(std::span<const Vec3> ring);

/// Forms of a ring of n >= 5 atoms in order (Angstrom), the given form first. Next come those with
/// its exact distances across one and two bonds: the mirror image, and for six atoms the results of
/// Gauss-Newton steps from an even chair and the six twist-boats. Then those that keep the bonds
/// and approach the angles in a number of damped steps: from ten envelopes of five atoms, and from
/// the chairs and twist-boats of six (D. Cremer, J. A. Pople, J. Am. Chem. Soc. 97 (1975) 1354).
/// Bonds between two atoms with `is_flat` (n) keep the size of their torsion to 12 degrees. Two
/// forms differ by 0.15 Angstrom (r.m.s.), or 0.08 for five atoms.
std::vector<RingForm> ring_forms(std::span<const Vec3> ring, const std::vector<bool>& is_flat);

}  // namespace pliant
