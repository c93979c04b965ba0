// SPDX-License-Identifier: MIT
// Hinges: where a piece of a molecule, with all that hangs on it, can turn against the rest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/turns/pieces.hpp"

namespace pliant {

struct Hinge {
  std::uint32_t piece = 0;    ///< that turns
  double weight = 0.0;        ///< square of the share of nodes on the smaller side
  std::vector<Vec3> middles;  ///< of the links across it (Angstrom)
  Vec3 centre;                ///< mean of these; of all nodes where there are none
  Vec3 line;                  ///< direction of the line through them; 0 for fewer than two
  /// Main axes of the turn in the modes, and their shares of its variance.
  std::array<Vec3, 3> axes;
  std::array<double, 3> softness{};
  /// How the piece shifts in the modes for each radian about these (Angstrom, of the origin).
  std::array<Vec3, 3> shifts;
};

/// The hinges of all pieces of a tree but the root, in the order of the pieces.
std::vector<Hinge> hinges_of(const NetworkNodes& nodes, const PieceTree& tree,
                             const NetworkModes& modes);

/// Pairs of nodes within `length` (Angstrom, times the scale of the nodes) that are no neighbours
/// along a chain; `moved` (M) are the nodes' places.
std::size_t pairs_within(double length, const NetworkNodes& nodes, std::span<const Vec3> moved);

}  // namespace pliant
