// SPDX-License-Identifier: MIT
// Reduces the number of nodes in the elastic network of a large assembly.
#pragma once

#include <cstddef>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

inline constexpr std::size_t most_network_nodes = 1000;

/// Returns `nodes` if there are at most `most`. Otherwise merges equal numbers of consecutive nodes
/// of a chain into one at their mean, as many as necessary; the density of nodes falls by that
/// number, and spring lengths grow by its cube root. Nodes that are chains by themselves (atoms of
/// ligands, ions) merge if they share a cell of a cubic grid. The edge of the cells is the length
/// of a residue, 5.1 Angstrom, times that root, or longer so that at most a quarter of `most` (or
/// 8) such nodes remain. Each fragment of a chain keeps a node, so that there may be more than
/// `most`.
NetworkNodes coarsened(NetworkNodes nodes, std::size_t most = most_network_nodes);

}  // namespace pliant
