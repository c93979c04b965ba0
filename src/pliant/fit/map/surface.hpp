// SPDX-License-Identifier: MIT
// Where a map has one value: its surface at a level, as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

struct Surface {
  std::vector<Vec3> vertices;                           ///< Angstrom
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise, seen from outside
};

/// The surface around what is at or above `level`, by surface nets (S. Gibson, MICCAI 1998, LNCS
/// 1496, 888): a vertex for each cell of the grid that it crosses, at the mean of where it crosses
/// the edges of that cell, and two triangles for each edge of the grid. It is closed, at the border
/// of the map too: beyond it there is nothing. Linear in points. Throws OptionError unless the
/// level is finite and not above the greatest value.
Surface surface_of(const DensityMap& map, double level);

/// The level that the densest points which fill `volume` (Angstrom^3) are at or above. Throws
/// OptionError unless that is above 0 and not more than the volume of the map.
double level_around(const DensityMap& map, double volume);

}  // namespace pliant
