// SPDX-License-Identifier: MIT
// Rigid clusters of bodies joined by bars, degrees of freedom, redundant bars, and the flexibility
// of each region. All follow from counting, whatever the positions.
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

/// Least number of bodies in a cluster. A single body, or two and the bond between them, is a small
/// piece.
inline constexpr std::uint32_t least_cluster = 3;

/// The cluster of each body. Clusters are numbered from 0 by size, the largest first, and among
/// equals by their lowest body; small pieces follow.
struct ClusterList {
  std::vector<std::uint32_t> of_body;  ///< (B)
  std::vector<std::uint32_t> sizes;    ///< (C) bodies

  /// Number of clusters with at least `least` bodies; these are the first ones.
  std::size_t count(std::uint32_t least = least_cluster) const;
  std::size_t small_pieces() const { return sizes.size() - count(); }
};

/// Numbers clusters that are given by one body for each body: `representative` (B).
ClusterList list_clusters(std::span<const std::uint32_t> representative);

struct RigidClusters {
  ClusterList clusters;
  std::vector<std::uint8_t> redundant;  ///< (E) bars of each edge that depend on earlier ones
  std::size_t bars = 0;
  std::size_t rank = 0;        ///< independent bars
  std::size_t components = 0;  ///< connected components of the network
  /// Internal degrees of freedom: 6 bodies - rank - 6 components.
  std::size_t freedoms = 0;
};

/// Plays the pebble game with the edges in this order: of bars that depend on each other, the last
/// ones are redundant. Throws InputError naming an edge whose ends are equal or do not exist.
RigidClusters find_rigid_clusters(std::size_t bodies, std::span<const BodyEdge> edges);

/// Calls are_locked() for the ends of all edges, so that the game knows all clusters.
void find_all_clusters(PebbleGame& game, std::span<const BodyEdge> edges);

/// Flexibility index of each edge (after Jacobs, Rader, Kuhn, Thorpe, Proteins 44 (2001) 150).
///
/// In a flexible region it is the region's degrees of freedom, divided by the sum over its edges of
/// those that each would have alone (6 - bars): 1 for a hinge that nothing else holds, 1/7 for a
/// ring of seven. Regions are the blocks (biconnected components) of the graph of clusters; their
/// degrees of freedom add up to the total. In a rigid cluster it is -(redundant bars) / bars, which
/// is 0 if no bar is redundant.
std::vector<double> flexibility_indices(std::span<const BodyEdge> edges,
                                        const RigidClusters& found);

}  // namespace pliant
