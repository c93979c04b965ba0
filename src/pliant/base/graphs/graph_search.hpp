// SPDX-License-Identifier: MIT
// The searches of graph.hpp; included where they are made for links of one name.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "pliant/base/graphs/graph.hpp"

namespace pliant {

/// Depth-first search that closes a block whenever a subtree cannot reach above its entry node.
template <class L>
class BlockSearch {
 public:
  explicit BlockSearch(const GraphOf<L>& graph)
      : graph_(graph),
        entered_(graph.node_count(), unset),
        low_(graph.node_count(), 0),
        next_(graph.node_count(), 0) {
    blocks_.of_edge.assign(graph.edge_count(), unset);
    blocks_.is_bridge.assign(graph.edge_count(), false);
  }

  Blocks run() {
    for (std::size_t i = 0; i < graph_.node_count(); ++i)
      if (entered_[i] == unset) search_from(static_cast<std::uint32_t>(i));
    return std::move(blocks_);
  }

 private:
  static constexpr auto unset = std::numeric_limits<std::uint32_t>::max();

  struct Visit {
    std::uint32_t node;
    std::uint32_t arrival;  ///< edge by which the node was entered; unset at a root
  };

  void search_from(std::uint32_t root) {
    enter(root, unset);
    while (!path_.empty()) {
      const Visit top = path_.back();
      const auto around = graph_.at(top.node);
      if (next_[top.node] < around.size()) {
        look_at(top, around[next_[top.node]++]);
      } else {
        leave(top);
      }
    }
  }

  void enter(std::uint32_t node, std::uint32_t arrival) {
    entered_[node] = low_[node] = clock_++;
    path_.push_back({node, arrival});
  }

  void look_at(const Visit& here, const L& link) {
    const auto [node, edge] = link;
    if (edge == here.arrival) return;
    if (entered_[node] == unset) {
      open_edges_.push_back(edge);
      enter(node, edge);
    } else if (entered_[node] < entered_[here.node]) {
      open_edges_.push_back(edge);
      low_[here.node] = std::min(low_[here.node], entered_[node]);
    }
  }

  void leave(const Visit& done) {
    path_.pop_back();
    if (path_.empty()) return;
    const std::uint32_t parent = path_.back().node;
    low_[parent] = std::min(low_[parent], low_[done.node]);
    if (low_[done.node] >= entered_[parent]) close_block(done.arrival);
  }

  void close_block(std::uint32_t first) {
    std::size_t size = 0;
    std::uint32_t edge = unset;
    while (edge != first) {
      edge = open_edges_.back();
      open_edges_.pop_back();
      blocks_.of_edge[edge] = static_cast<std::uint32_t>(blocks_.count);
      ++size;
    }
    if (size == 1) {
      blocks_.is_bridge[first] = true;
      ++blocks_.bridge_count;
    }
    blocks_.largest = std::max(blocks_.largest, size);
    ++blocks_.count;
  }

  const GraphOf<L>& graph_;
  std::vector<std::uint32_t> entered_, low_, next_;
  std::vector<Visit> path_;
  std::vector<std::uint32_t> open_edges_;
  std::uint32_t clock_ = 0;
  Blocks blocks_;
};

template <class L>
Components find_components(const GraphOf<L>& graph) {
  constexpr auto unset = std::numeric_limits<std::uint32_t>::max();
  Components found;
  found.of_node.assign(graph.node_count(), unset);
  std::vector<std::uint32_t> waiting;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    if (found.of_node[i] != unset) continue;
    const auto id = static_cast<std::uint32_t>(found.count++);
    found.lowest_node.push_back(static_cast<std::uint32_t>(i));
    found.of_node[i] = id;
    waiting.assign(1, static_cast<std::uint32_t>(i));
    while (!waiting.empty()) {
      const std::uint32_t here = waiting.back();
      waiting.pop_back();
      for (const auto& [node, edge] : graph.at(here)) {
        if (found.of_node[node] != unset) continue;
        found.of_node[node] = id;
        waiting.push_back(node);
      }
    }
  }
  return found;
}

template <class L>
Blocks find_blocks(const GraphOf<L>& graph) {
  return BlockSearch<L>(graph).run();
}

}  // namespace pliant
