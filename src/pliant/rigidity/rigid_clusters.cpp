// SPDX-License-Identifier: MIT
#include "pliant/rigidity/rigid_clusters.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/graphs/graph.hpp"
#include "pliant/base/graphs/grouped.hpp"

namespace pliant {
namespace {

void check(std::size_t bodies, std::span<const BodyEdge> edges) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto [a, b, bars] = edges[k];
    if (a == b || a >= bodies || b >= bodies)
      throw InputError("edge " + std::to_string(k) + " joins bodies " + std::to_string(a) +
                       " and " + std::to_string(b) + ": expected two of " + std::to_string(bodies) +
                       " (counted from 0)");
  }
}

std::size_t count_components(std::size_t bodies, std::span<const BodyEdge> edges) {
  DisjointSets sets;
  sets.reset(bodies);
  std::size_t count = bodies;
  for (const BodyEdge& edge : edges)
    if (edge.bars > 0 && sets.unite(edge.a, edge.b)) --count;
  return count;
}

/// Edges between different clusters, as a graph of clusters.
class ClusterGraph {
 public:
  ClusterGraph(std::span<const BodyEdge> edges, const ClusterList& clusters)
      : edges_(edges), clusters_(clusters) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::uint32_t a = clusters.of_body[edges[k].a], b = clusters.of_body[edges[k].b];
      if (a == b || edges[k].bars == 0) continue;
      ends_.push_back({a, b});
      edge_.push_back(k);
    }
  }

  /// Fills in the indices of the edges.
  void rate(std::vector<double>& indices) const {
    const Blocks blocks = find_blocks(Graph(clusters_.sizes.size(), ends_));
    const Grouped<std::uint32_t> of_block(blocks.count, [&](const auto& put) {
      for (std::size_t k = 0; k < ends_.size(); ++k)
        put(blocks.of_edge[k], static_cast<std::uint32_t>(k));
    });
    std::vector<std::size_t> last_block(clusters_.sizes.size(), blocks.count);
    for (std::size_t block = 0; block < blocks.count; ++block) {
      std::size_t nodes = 0, bars = 0, own = 0;
      for (const std::uint32_t k : of_block.at(block)) {
        bars += edges_[edge_[k]].bars;
        own += freedoms_of_body - edges_[edge_[k]].bars;
        for (const std::uint32_t node : {ends_[k].a, ends_[k].b})
          if (std::exchange(last_block[node], block) != block) ++nodes;
      }
      const std::size_t freedoms = freedoms_of_body * (nodes - 1) - bars;
      for (const std::uint32_t k : of_block.at(block))
        indices[edge_[k]] = static_cast<double>(freedoms) / static_cast<double>(own);
    }
  }

 private:
  std::span<const BodyEdge> edges_;
  const ClusterList& clusters_;
  std::vector<Graph::Edge> ends_;
  std::vector<std::size_t> edge_;
};

}  // namespace

std::size_t ClusterList::count(std::uint32_t least) const {
  const auto end =
      std::find_if(sizes.begin(), sizes.end(), [&](std::uint32_t size) { return size < least; });
  return static_cast<std::size_t>(end - sizes.begin());
}

ClusterList list_clusters(std::span<const std::uint32_t> representative) {
  std::vector<std::uint32_t> sizes(representative.size(), 0), firsts, place(sizes);
  for (const std::uint32_t first : representative)
    if (sizes[first]++ == 0) firsts.push_back(first);  // in the order of their lowest bodies
  std::stable_sort(firsts.begin(), firsts.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return sizes[x] > sizes[y]; });
  ClusterList list;
  for (const std::uint32_t first : firsts) {
    place[first] = static_cast<std::uint32_t>(list.sizes.size());
    list.sizes.push_back(sizes[first]);
  }
  for (const std::uint32_t first : representative) list.of_body.push_back(place[first]);
  return list;
}

void find_all_clusters(PebbleGame& game, std::span<const BodyEdge> edges) {
  for (const BodyEdge& edge : edges)
    if (edge.bars > 0) game.are_locked(edge.a, edge.b);
}

RigidClusters find_rigid_clusters(std::size_t bodies, std::span<const BodyEdge> edges) {
  check(bodies, edges);
  PebbleGame game(bodies);
  RigidClusters found;
  for (const BodyEdge& edge : edges) {
    const std::uint32_t independent = game.add(edge.a, edge.b, edge.bars);
    found.redundant.push_back(static_cast<std::uint8_t>(edge.bars - independent));
    found.bars += edge.bars;
  }
  find_all_clusters(game, edges);
  std::vector<std::uint32_t> representative(bodies);
  for (std::size_t k = 0; k < bodies; ++k)
    representative[k] = game.cluster_of(static_cast<std::uint32_t>(k));
  found.clusters = list_clusters(representative);
  found.rank = game.rank();
  found.components = count_components(bodies, edges);
  found.freedoms = freedoms_of_body * (bodies - found.components) - found.rank;
  return found;
}

std::vector<double> flexibility_indices(std::span<const BodyEdge> edges,
                                        const RigidClusters& found) {
  const auto& of_body = found.clusters.of_body;
  std::vector<std::size_t> bars(found.clusters.sizes.size(), 0), redundant(bars);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (of_body[edges[k].a] != of_body[edges[k].b]) continue;
    bars[of_body[edges[k].a]] += edges[k].bars;
    redundant[of_body[edges[k].a]] += found.redundant[k];
  }
  std::vector<double> indices(edges.size(), 0.0);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::uint32_t cluster = of_body[edges[k].a];
    if (redundant[cluster] > 0 && cluster == of_body[edges[k].b])
      indices[k] = -static_cast<double>(redundant[cluster]) / static_cast<double>(bars[cluster]);
  }
  ClusterGraph(edges, found.clusters).rate(indices);
  return indices;
}

}  // namespace pliant
