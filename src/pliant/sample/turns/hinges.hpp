// SPDX-License-Identifier: MIT
// Hinges: where a piece of a molecule, with all that hangs on it, can turn against the rest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/turns/pieces.hpp"

namespace pliant {

struct Hinge {
  std::uint32_t piece = 0;     ///< that turns
  double weight = 0.0;         ///< square of the share of nodes on the smaller side
  std::vector<Vec3> middles;   ///< of the links across it (Angstrom)
  Vec3 centre;                 ///< mean of these; of all nodes where there are none
  Vec3 line;                   ///< direction of the line through them; 0 for fewer than two
  std::array<double, 9> soft;  ///< covariance of the turn in the modes (3 x 3), over its trace
};

/// The hinges of all pieces of a tree but the root, in the order of the pieces.
std::vector<Hinge> hinges_of(const NetworkNodes& nodes, const PieceTree& tree,
                             const NetworkModes& modes);

/// The share of turns about an axis (of unit length) among those that the modes make, 0 to 1.
double softness(const Hinge& hinge, Vec3 axis);

}  // namespace pliant
