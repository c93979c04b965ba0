// SPDX-License-Identifier: MIT
// Turns as a first guess of a way. The parts of a molecule that keep their shape between both ends
// turn as wholes, along arcs, which no straight line follows.
#pragma once

#include <span>
#include <vector>

#include "pliant/path/ends.hpp"

namespace pliant {

/// Goals that lead to the end by turns of pieces.
struct TurnWay {
  double angle = 0.0;    ///< degrees: the largest turn of a piece against its parent
  double clashes = 0.0;  ///< TurnGuess::clashes
  std::vector<std::vector<Vec3>> goals;  ///< K positions each (Angstrom), the end last
};

/// Divides the residues by which distances change between the start and `goal` (K), as find_pieces
/// does: the coarsest division that explains three quarters of the mean square distance. A turn
/// above 120 degrees is offered both ways round. The way on which pieces clash least comes first.
/// None if no piece turns by 45 degrees or more.
std::vector<TurnWay> find_turn_ways(const PathSide& start, std::span<const Vec3> goal);

}  // namespace pliant
