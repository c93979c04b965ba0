// SPDX-License-Identifier: MIT
// Graph: nodes joined by edges, its connected components, bridges and blocks (biconnected
// components). All linear in nodes + edges, none recursive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"

namespace pliant {

/// A node reached over an edge.
struct Link {
  std::uint32_t node, edge;
};

/// A graph whose links are called `L`: two numbers, the node and the edge over which it is reached.
template <class L>
class GraphOf {
 public:
  /// Two nodes.
  struct Edge {
    std::uint32_t a, b;
  };

  /// No nodes.
  GraphOf() = default;
  /// Takes an array of `edges` whose ends a and b are below `nodes`; there are fewer than 2^31
  /// edges.
  template <class Edges>
  GraphOf(std::size_t nodes, const Edges& edges)
      : links_(nodes, [&](const auto& put) {
          for (std::size_t k = 0; k < edges.size(); ++k) {
            const auto edge = static_cast<std::uint32_t>(k);
            put(edges[k].a, L{edges[k].b, edge});
            put(edges[k].b, L{edges[k].a, edge});
          }
        }) {}

  std::size_t node_count() const { return links_.size(); }
  std::size_t edge_count() const { return links_.things().size() / 2; }
  /// The links at a node, in the order of the edges.
  std::span<const L> at(std::size_t node) const { return links_.at(node); }

 private:
  Grouped<L> links_;
};

using Graph = GraphOf<Link>;

/// Which component each node is in; components are numbered by their lowest node.
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_node;      ///< (nodes)
  std::vector<std::uint32_t> lowest_node;  ///< (count)
};

template <class L>
Components find_components(const GraphOf<L>& graph);

/// Which block each edge is in. A bridge (an edge on no cycle) is a block of one edge.
struct Blocks {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_edge;  ///< (edges)
  std::vector<bool> is_bridge;         ///< (edges)
  std::size_t bridge_count = 0;
  std::size_t largest = 0;  ///< edges in the largest block
};

/// Blocks by lowpoints (Hopcroft, Tarjan, CACM 16 (1973) 372).
template <class L>
Blocks find_blocks(const GraphOf<L>& graph);

}  // namespace pliant
