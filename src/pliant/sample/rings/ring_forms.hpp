// SPDX-License-Identifier: MIT
// The forms that a ring can take with all its lengths and angles: chairs and twist-boats of six
// atoms, the mirror image of any ring.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// One form of a ring.
struct RingForm {
  std::vector<Vec3> positions;  ///< (n) Angstrom, somewhere
  bool is_chair = false;        ///< torsions of both signs in turn, all round a ring of six
};

/// Whether it is a ring of six with torsions of both signs in turn.
bool is_chair(std::span<const Vec3> ring);

/// Forms of a ring of n atoms in order (n from 5, Angstrom); the ring itself is the first. First
/// those that have its distances across one and two bonds: the mirror image, and of six atoms what
/// Gauss-Newton steps reach from an even chair and the six twist-boats. Then, of five atoms from
/// ten envelopes, of six from the chairs and twist-boats (D. Cremer, J. A. Pople, J. Am. Chem. Soc.
/// 97 (1975) 1354), those that keep the bonds and come as near to the angles as some damped steps
/// bring them. Bonds between two atoms of which `is_flat` (n) keep the size of their torsion, to 12
/// degrees. Two forms differ by 0.15 Angstrom (r.m.s.), of five atoms by 0.08.
std::vector<RingForm> ring_forms(std::span<const Vec3> ring, const std::vector<bool>& is_flat);

}  // namespace pliant
