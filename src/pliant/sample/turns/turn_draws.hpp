// SPDX-License-Identifier: MIT
// Draws turns of domains: which pieces turn, about which axis and how far, as far as links and
// sterics allow.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/turns/hinges.hpp"
#include "pliant/sample/turns/pieces.hpp"
#include "pliant/sample/turns/plausible_shapes.hpp"
#include "pliant/sample/turns/turn_course.hpp"
#include "pliant/sample/turns/turn_limits.hpp"

namespace pliant {

/// The turns of one frame; tree is null if there are none.
struct DrawnTurns {
  std::shared_ptr<const PieceTree> tree;
  std::vector<PieceTurn> turns;
};

class TurnDraws {
 public:
  /// `nodes` must outlive it.
  TurnDraws(const NetworkNodes& nodes, NetworkModes modes);

  /// Whether no piece can turn against the rest.
  bool empty() const { return trees_.empty(); }

  /// Draws many candidates, and takes one by how plausible they are, of those whose links can be
  /// closed and whose nodes seldom come too near to each other; with smaller angles where there is
  /// none. Several threads may call it at once.
  DrawnTurns draw(RandomSequence& draws) const;

 private:
  struct Tree {
    std::shared_ptr<const PieceTree> pieces;
    std::vector<Hinge> hinges;
  };

  struct Candidate {
    DrawnTurns turns;
    double rank = 0.0;
  };

  Candidate draw_candidate(double scale, RandomSequence& draws) const;
  const Tree& choose_tree(std::size_t pieces, RandomSequence& draws) const;
  DrawnTurns draw_turns(std::size_t pieces, double scale, RandomSequence& draws) const;
  DrawnTurns turns_in_modes(double scale, RandomSequence& draws) const;
  std::vector<Vec3> moved(const DrawnTurns& drawn) const;

  const NetworkNodes& nodes_;
  NetworkModes modes_;
  std::vector<Tree> trees_;
  TurnLimits limits_;
  PlausibleShapes plausible_;
};

}  // namespace pliant
