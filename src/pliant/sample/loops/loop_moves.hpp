// SPDX-License-Identifier: MIT
// Loops of proteins that are redrawn between their ends: segments that few contacts hold.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "pliant/sample/loops/loop_residues.hpp"

namespace pliant {

inline constexpr std::size_t shortest_loop = 6, longest_loop = 15;  ///< residues
inline constexpr std::size_t most_loops = 3;                        ///< that a frame redraws
inline constexpr int attempts_at_loops = 5;  ///< at a frame: after so many in vain none is redrawn

/// Residues [first, last) of those of LoopMoves.
struct LoopSegment {
  std::size_t first = 0, last = 0;
};

class LoopMoves {
 public:
  /// Loops with a residue that is in_place (residues of the atom table; empty: anywhere). None has
  /// residues that a metal or a bond beyond the chain holds. All must outlive it.
  LoopMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start,
            const std::vector<bool>& in_place = {});

  std::span<const LoopResidue> residues() const { return residues_; }
  std::span<const LoopSegment> segments() const { return segments_; }
  bool empty() const { return segments_.empty(); }

  /// Redraws up to `most` loops of `x` (N, Angstrom: the start, but for side chains) that have no
  /// residue in common. Bars are exact, and backbones overlap with no other. Returns which. Several
  /// threads may call it at once.
  std::vector<LoopSegment> redraw(RandomSequence& draws, std::size_t most, std::span<Vec3> x) const;

 private:
  void find_segments(const std::vector<bool>& in_place);
  void find_backbone();
  const LoopSegment& choose(RandomSequence& draws) const;
  bool redraw(const LoopSegment& segment, RandomSequence& draws, std::span<Vec3> x) const;
  bool fits(std::span<const LoopResidue> loop, std::span<const Vec3> x) const;

  const Framework& framework_;
  std::span<const Vec3> start_;
  std::vector<LoopResidue> residues_;
  std::vector<LoopSegment> segments_;
  std::vector<double> weights_;  ///< (segments) sums of those so far
  std::optional<LeastDistances> rules_;
  std::vector<Joint> backbone_;    ///< heavy atoms that no side chain turns away
  std::vector<bool> is_backbone_;  ///< (N)
};

}  // namespace pliant
