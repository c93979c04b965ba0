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
#include "pliant/sample/turns/turn_course.hpp"
#include "pliant/sample/turns/turn_limits.hpp"

namespace pliant {

/// The turns of one frame; tree is null if there are none.
struct DrawnTurns {
  std::shared_ptr<const PieceTree> tree;
  std::vector<PieceTurn> turns;
};

/// One of the ways in which the turn of a piece is drawn.
struct TurnWay {
  double share;     ///< of all ways of hinges that are open, or closed
  double power;     ///< axes are as frequent as they are soft, to this power; 0: at random
  int best_of;      ///< of so many that are possible
  double contacts;  ///< +1: the one with the most, -1: with the fewest contacts between nodes
};

class TurnDraws {
 public:
  /// `nodes` must outlive it.
  TurnDraws(const NetworkNodes& nodes, NetworkModes modes);

  /// Whether no piece can turn against the rest.
  bool empty() const { return trees_.empty(); }

  /// Draws until links can be closed and few nodes come too near to each other, by smaller angles
  /// after draws in vain. Several threads may call it at once.
  DrawnTurns draw(RandomSequence& draws) const;

 private:
  struct Tree {
    std::shared_ptr<const PieceTree> pieces;
    std::vector<Hinge> hinges;
  };

  const Tree& choose_tree(std::size_t pieces, RandomSequence& draws) const;
  DrawnTurns draw_turns(std::size_t pieces, double scale, RandomSequence& draws) const;
  bool add_turn(const Hinge& hinge, double scale, RandomSequence& draws, DrawnTurns& drawn) const;
  DrawnTurns draw_along_modes(double scale, RandomSequence& draws) const;
  DrawnTurns turns_in_modes(double scale, RandomSequence& draws) const;
  std::vector<Vec3> moved(const DrawnTurns& drawn) const;

  const NetworkNodes& nodes_;
  NetworkModes modes_;
  std::vector<Tree> trees_;
  TurnLimits limits_;
};

}  // namespace pliant
