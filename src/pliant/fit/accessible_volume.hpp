// SPDX-License-Identifier: MIT
// Where a dye on a flexible linker can be: its accessible volume.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// A ball at the end of a linker, Angstrom.
struct Dye {
  double length = 20.0;  ///< of the linker, as long as it can be
  double width = 4.5;    ///< of the linker
  double radius = 3.5;   ///< of the ball

  /// Throws OptionError unless all are above 0 and at most 100.
  void check() const;
};

/// The centres of a dye, points of a grid of 1 Angstrom: where it touches no atom, and where a
/// linker that touches none is long enough to come. `radii` (n) of the atoms (n), Angstrom; near to
/// where the linker is attached (its width and a step) it goes straight through all. None where
/// atoms leave no room. Paths are at most 4 % longer than between points that are no grid's.
///
/// S. Sindbert et al., J. Am. Chem. Soc. 133 (2011) 2463; S. Kalinin et al., Nat. Methods 9 (2012)
/// 1218. O(V log V) for V = length^3, and linear in the number of atoms.
std::vector<Vec3> accessible_volume(std::span<const Vec3> atoms, std::span<const double> radii,
                                    Vec3 attached, const Dye& dye = {});

}  // namespace pliant
