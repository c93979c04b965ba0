// SPDX-License-Identifier: MIT
// Pockets of a structure on a grid: room for a small probe, out of reach of a large one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

inline constexpr double small_probe = 1.4;  ///< radius of water, Angstrom
inline constexpr double large_probe = 4.0;  ///< Angstrom
inline constexpr double least_depth = 2.4;  ///< how deep below the large probe a pocket begins
inline constexpr double pocket_step = 1.0;  ///< of the grid, Angstrom
inline constexpr double least_pocket =
    30.0;  ///< connected room that is smaller is none, Angstrom^3

/// The room of all pockets, point by point of a grid.
struct PocketPoints {
  std::vector<std::int64_t> pocket;  ///< of each point, from 0 by size
  std::vector<std::int64_t> atom;    ///< the nearest to each point
};

/// Pockets between atoms at `positions` (n) of `radii` (n), Angstrom.
///
/// A point is in a pocket where a sphere of small_probe that touches no atom covers it, and where
/// no sphere of large_probe that comes from outside covers it or comes nearer than least_depth (N.
/// Voss, M. Gerstein, Nucleic Acids Res. 38 (2010) W555; T. Oliveira et al., BMC Bioinformatics 15
/// (2014) 197). A wide cleft that is open to water is no pocket.
PocketPoints find_pockets(std::span<const Vec3> positions, std::span<const double> radii);

}  // namespace pliant
