// SPDX-License-Identifier: MIT
// Draws turns of domains: which pieces turn, about which axis and how far, as far as links and
// sterics allow.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/turns/hinges.hpp"
#include "pliant/sample/turns/pieces.hpp"
#include "pliant/sample/turns/turn_course.hpp"

namespace pliant {

/// The turns of one frame; tree is null if there are none.
struct DrawnTurns {
  const PieceTree* tree = nullptr;
  std::vector<PieceTurn> turns;
};

/// One of the ways in which turns are drawn.
struct TurnWay {
  double share;    ///< of all draws
  int pieces;      ///< that turn; 0: all, as a draw of the modes turns them
  int best_of;     ///< each turn is the best of so many, by the ranks of
  double closing;  ///<   contacts between nodes, with this weight, and of
  double soft;     ///<   the softness of its axis
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
    PieceTree pieces;
    std::vector<Hinge> hinges;
  };

  const Tree& choose_tree(RandomSequence& draws) const;
  DrawnTurns draw_turns(const TurnWay& way, double scale, RandomSequence& draws) const;
  bool add_best(const TurnWay& way, const Hinge& hinge, double scale, RandomSequence& draws,
                DrawnTurns& drawn) const;
  DrawnTurns draw_along_modes(double scale, RandomSequence& draws) const;
  DrawnTurns turns_in_modes(double scale, RandomSequence& draws) const;
  bool is_possible(std::span<const Vec3> moved) const;
  std::vector<Vec3> moved(const DrawnTurns& drawn) const;
  std::size_t pairs_within(double length, std::span<const Vec3> nodes) const;

  const NetworkNodes& nodes_;
  NetworkModes modes_;
  std::vector<Tree> trees_;
  std::size_t near_at_start_ = 0;
};

}  // namespace pliant
