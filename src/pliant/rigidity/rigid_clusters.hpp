// SPDX-License-Identifier: MIT
// Rigid clusters of bodies joined by bars, degrees of freedom, redundant bars, and how flexible
// each region is: all by counting, whatever the positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/rigidity/pebble_game.hpp"

namespace pliant {

/// Two bodies and the number of bars between them: five for a hinge, six for a bond that does not
/// turn.
struct BodyEdge {
  std::uint32_t a = 0, b = 0;
  std::uint8_t bars = 0;
};

/// Fewer bodies that are locked together (one, or two and the bond between them) are no cluster but
/// a small piece.
inline constexpr std::uint32_t least_cluster = 3;

/// Which cluster each body is in, small pieces numbered after them. Clusters are numbered from 0 by
/// size, the largest first, and among equals by their lowest body.
struct ClusterList {
  std::vector<std::uint32_t> of_body;  ///< (B)
  std::vector<std::uint32_t> sizes;    ///< (C) bodies

  /// Clusters of so many bodies or more: the first ones.
  std::size_t count(std::uint32_t least = least_cluster) const;
  std::size_t small_pieces() const { return sizes.size() - count(); }
};

/// Numbers clusters that are told by one body of each: `representative` (B).
ClusterList list_clusters(std::span<const std::uint32_t> representative);

struct RigidClusters {
  ClusterList clusters;
  std::vector<std::uint8_t> redundant;  ///< (E) bars of each edge that depend on those before them
  std::size_t bars = 0;
  std::size_t rank = 0;        ///< independent bars
  std::size_t components = 0;  ///< parts of the network that nothing links
  /// Internal degrees of freedom: 6 bodies - rank - 6 components.
  std::size_t freedoms = 0;
};

/// Plays the pebble game with edges in this order: where bars depend on each other, the last ones
/// are redundant. Throws InputError naming an edge whose ends are one body or none.
RigidClusters find_rigid_clusters(std::size_t bodies, std::span<const BodyEdge> edges);

/// Asks the ends of all edges whether they are locked, so that the game knows all clusters.
void find_all_clusters(PebbleGame& game, std::span<const BodyEdge> edges);

/// How freely each edge moves (flexibility index, after Jacobs, Rader, Kuhn, Thorpe, Proteins 44
/// (2001) 150), one number an edge.
///
/// In a region that moves as a whole: its degrees of freedom / those that its edges would have each
/// alone (6 - bars). 1 for a hinge that nothing else holds, 1/7 for a ring of seven. Regions are
/// the blocks (biconnected components) of the graph of clusters; degrees of freedom of blocks add
/// up to those of all. In a rigid cluster: - redundant bars / bars, which is 0 where none is
/// redundant.
std::vector<double> flexibility_indices(std::span<const BodyEdge> edges,
                                        const RigidClusters& found);

}  // namespace pliant
