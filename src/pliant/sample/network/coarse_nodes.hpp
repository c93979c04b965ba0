// SPDX-License-Identifier: MIT
// Fewer nodes for the elastic network of a large assembly.
#pragma once

#include <cstddef>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

inline constexpr std::size_t most_network_nodes = 1000;

/// The same if there are no more than `most` nodes. Else as many consecutive nodes of a chain
/// become one, at their mean, as it takes; the density of nodes then falls by that number, and
/// lengths of springs grow by its cube root. Nodes that are a chain of their own (atoms of ligands,
/// ions) become one where they share a cell of a cubic grid, whose edge is the length of a residue,
/// 5.1 Angstrom, times that root, or longer, so that there are no more than a quarter of `most` (or
/// 8) of them. Each broken piece of a chain keeps a node, so that there may be more than `most`.
NetworkNodes coarsened(NetworkNodes nodes, std::size_t most = most_network_nodes);

}  // namespace pliant
