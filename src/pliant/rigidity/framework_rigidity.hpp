// SPDX-License-Identifier: MIT
// What of a framework is rigid: its degrees of freedom, redundant bars and overconstrained parts,
// at its positions, at almost all others, and by counting bars.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/rigidity/bar_rank.hpp"

namespace pliant {

/// Motions of the joints that change no length of a bar to first order.
struct Motions {
  std::size_t all = 0;       ///< independent ones: coordinates that are not pinned, less the rank
  std::size_t of_whole = 0;  ///< of these, those in which all distances stay what they are
  /// Internal degrees of freedom. Parts that nothing links move against each other: that counts.
  std::size_t internal() const { return all - of_whole; }
};

/// Redundant bars that hang together over joints that are not pinned.
struct OverconstrainedPart {
  std::vector<BarIndex> bars;  ///< ascending
  std::size_t joints = 0;
  std::size_t self_stresses = 0;
};

struct FrameworkRigidity {
  std::uint32_t dimension = 3;  ///< 2: of a planar framework, whose joints keep their z
  std::size_t parts = 0;        ///< connected components of the graph
  BarRankThere rank;
  BarRank generic_rank;
  std::size_t counted_rank = 0;                      ///< by JointPebbles
  Motions motions;                                   ///< at the positions
  Motions generic_motions;                           ///< at almost all positions
  Motions counted_motions;                           ///< by JointPebbles
  std::vector<OverconstrainedPart> overconstrained;  ///< at the positions, largest first
};

/// Limits and sterics hold nothing here, and pinned joints are where they are for good. Where there
/// are more motions at the positions than at almost all, some may end at once: their first order is
/// all there is of them. Else they go on. Throws InputError if the number of positions is not that
/// of the joints, or one is not finite.
FrameworkRigidity framework_rigidity(const Framework& framework, std::span<const Vec3> positions);

}  // namespace pliant
