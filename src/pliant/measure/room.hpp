// SPDX-License-Identifier: MIT
// Room between atoms that are given, and how much of it is enclosed.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/vec3.hpp"
#include "pliant/measure/pockets.hpp"

namespace pliant {

/// Room within a convex hull, Angstrom^3.
struct Room {
  double all = 0.0;
  double enclosed = 0.0;  ///< where atoms are around: see room_among
};

/// Room for small_probe within the convex hull of lining atoms, given by their numbers.
///
/// `positions` (n), `radii` (n): all atoms, Angstrom; `step` of the grid, which lies `offset` steps
/// further along x, y and z. Unlike that of find_pockets this room does not end where a large probe
/// comes in: it grows as a pocket opens, up to planes across its mouth. (Room in a region that is
/// given: J. Durrant et al., J. Chem. Theory Comput. 10 (2014) 5047.) Where the lining parts, the
/// hull spans the gap, which is not enclosed: a place is where half of all directions meet an atom
/// within 8 Angstrom; midway between two walls that are further apart, none is. (Rays that meet the
/// protein: T. Halgren, J. Chem. Inf. Model. 49 (2009) 377.)
Room room_among(std::span<const Vec3> positions, std::span<const double> radii,
                std::span<const std::uint32_t> lining, double step = pocket_step,
                double offset = 0.0);

}  // namespace pliant
