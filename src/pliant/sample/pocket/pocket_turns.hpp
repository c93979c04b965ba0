// SPDX-License-Identifier: MIT
// Turns of pieces beside a place: segments of a chain that touch it, and domains that it lies
// between.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/turns/turn_draws.hpp"
#include "pliant/sample/turns/turn_limits.hpp"

namespace pliant {

class PocketTurns {
 public:
  /// `nodes` must outlive it. `in_place` (M): which nodes are in the place.
  PocketTurns(const NetworkNodes& nodes, const NetworkModes& modes,
              const std::vector<bool>& in_place);

  /// Draws turns, by angles smaller by the factor `scale`. Several threads may call it at once.
  DrawnTurns draw(RandomSequence& draws, double scale) const;

 private:
  struct Segment {
    std::size_t first = 0, last = 0;  ///< nodes [first, last)
  };

  DrawnTurns draw_domains(RandomSequence& draws, double scale) const;
  DrawnTurns draw_segments(RandomSequence& draws, double scale) const;
  std::optional<Segment> draw_segment(RandomSequence& draws) const;
  bool add_turn(const Segment& segment, double scale, RandomSequence& draws, DrawnTurns& out) const;
  PieceTurn turn_of(const Segment& segment, double scale, RandomSequence& draws) const;
  bool parts_place(const DrawnTurns& drawn) const;
  bool is_in_chain(std::size_t node, std::size_t of) const;

  const NetworkNodes& nodes_;
  TurnDraws domains_;
  TurnLimits limits_;
  std::vector<std::size_t> place_;  ///< its nodes that are in chains of several
};

}  // namespace pliant
