// SPDX-License-Identifier: MIT
// Pieces of a molecule: sets of nodes of its elastic network that keep their shape while domains
// turn, as a tree along the chains that join them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/network/network_modes.hpp"

namespace pliant {

/// Two consecutive nodes of a chain in different pieces.
struct ChainLink {
  std::uint32_t before, after;
};

/// One way to divide the nodes.
struct PieceTree {
  std::vector<std::uint32_t> of_node;  ///< (M) the piece of each node
  std::vector<std::int32_t> parent;  ///< (P) an earlier piece; -1: the largest, with which all stay
  std::vector<ChainLink> links;      ///< in the order of their nodes
  std::size_t piece_count() const { return parent.size(); }
};

/// How many nodes the smallest piece has: a fifth of all, from 5 to 20.
std::size_t least_piece(std::size_t nodes);

/// Different divisions into 2 to 8 pieces, the coarsest first; none if the molecule has no two
/// pieces. Cut by average linkage, once of the nodes' places in the 8 lowest modes of the Kirchhoff
/// matrix, each over the root of its eigenvalue (spectral clustering), and once of the changes of
/// their distances in the 10 lowest of `modes`. Along chains each node goes with most of its 7
/// neighbours, and pieces that are too small with the one that they are joined to.
std::vector<PieceTree> find_pieces(const NetworkNodes& nodes, const NetworkModes& modes);

/// Likewise by the changes of distances between the nodes and `other` (M, Angstrom), other places
/// of the same nodes.
std::vector<PieceTree> find_pieces(const NetworkNodes& nodes, std::span<const Vec3> other);

}  // namespace pliant
