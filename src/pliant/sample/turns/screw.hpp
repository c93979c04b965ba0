// SPDX-License-Identifier: MIT
// Rigid motions to first order (screws, twists), fitted to displacements of nodes.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// A point x moves by turn x x + shift.
struct Screw {
  Vec3 turn;   ///< radians, along the axis
  Vec3 shift;  ///< Angstrom, of the origin
};

/// The screw that fits `moves` (M, Angstrom) of the nodes (M) best by least squares, over those
/// with of_node[i] == part. Turns about a line on which all of them lie are left out.
Screw screw_of(std::span<const Vec3> nodes, std::span<const Vec3> moves,
               std::span<const std::uint32_t> of_node, std::uint32_t part);

}  // namespace pliant
