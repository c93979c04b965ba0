// SPDX-License-Identifier: MIT
// Draws turns of domains: which pieces turn, about which axis and how far, as far as links and
// sterics allow.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/turns/pieces.hpp"
#include "pliant/sample/turns/turn_course.hpp"

namespace pliant {

/// The turns of one frame; tree is null if there are none.
struct DrawnTurns {
  const PieceTree* tree = nullptr;
  std::vector<PieceTurn> turns;
};

class TurnDraws {
 public:
  /// `nodes` must outlive it.
  TurnDraws(const NetworkNodes& nodes, const NetworkModes& modes);

  /// Whether no piece can turn against the rest.
  bool empty() const { return hinges_.empty(); }

  /// Draws until links can be closed and few nodes come too near to each other, by smaller
  /// angles after draws in vain.
  DrawnTurns draw(RandomSequence& draws) const;

 private:
  /// Where a piece, with all that hangs on it, turns against the rest.
  struct Hinge {
    std::size_t tree = 0;
    std::uint32_t piece = 0;
    double weight = 0.0;         ///< square of the share of nodes on the smaller side
    std::vector<Vec3> middles;   ///< of the links across it
    Vec3 centre;                 ///< mean of these; of all nodes where there are none
    Vec3 line;                   ///< direction of the line through them; 0 for fewer than two
    std::array<double, 9> soft;  ///< covariance of the turn in the modes, over its trace
  };
  /// What is asked of a draw, and how many it is the best of.
  struct Way;
  struct ScoredTurn {
    PieceTurn turn;
    double contacts, softness;
  };

  Hinge hinge_of(std::size_t tree, std::uint32_t piece, const NetworkModes& modes) const;
  const Hinge& choose(std::span<const Hinge> among, RandomSequence& draws) const;
  std::span<const Hinge> of_tree(std::size_t tree) const;
  static PieceTurn turn_of(const Hinge& hinge, RandomSequence& draws);
  DrawnTurns draw_turns(const Way& way, double scale, RandomSequence& draws) const;
  bool add_best(const Way& way, const Hinge& hinge, double scale, RandomSequence& draws,
                DrawnTurns& drawn) const;
  DrawnTurns draw_along_modes(double scale, RandomSequence& draws) const;
  DrawnTurns turns_in_modes(double scale, RandomSequence& draws) const;
  bool is_possible(std::span<const Vec3> moved) const;
  std::vector<Vec3> moved(const DrawnTurns& drawn) const;
  static double softness(const Hinge& hinge, Vec3 axis);
  std::size_t pairs_within(double length, std::span<const Vec3> nodes) const;

  const NetworkNodes& nodes_;
  NetworkModes modes_;
  std::vector<PieceTree> trees_;
  std::vector<Hinge> hinges_;            ///< by tree
  std::vector<std::size_t> first_of_tree_;
  std::size_t near_at_start_ = 0;
};

}  // namespace pliant
