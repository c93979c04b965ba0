// SPDX-License-Identifier: MIT
// Spheres in a grid that touch no atom, and the room that they cover.
#pragma once

#include <span>
#include <vector>

#include "pliant/measure/grid.hpp"

namespace pliant {

/// The radius of the sphere about each point of a grid that touches no atom; `most` at most.
/// `places` (n) and `radii` (n) of atoms; lengths are in steps of the grid.
std::vector<float> free_radii(const Grid& grid, std::span<const Vec3> places,
                              std::span<const double> radii, double most);

/// The points within the sphere about the centre that is nearest to them, of `radius` (Angstrom).
/// A sphere that is larger than the probe is full of places for the probe: taking all of it, and
/// not the probe alone, is what makes a coarse grid good enough. `step` of the grid: Angstrom.
Mask covered(const Grid& grid, const Mask& centres, std::span<const float> radius, double step);

}  // namespace pliant
