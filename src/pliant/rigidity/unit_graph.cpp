// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "pliant/base/graphs/disjoint_sets.hpp"

namespace pliant {
namespace {

/// Finds the connections, and collects an edge of the graph of links for each of their units.
class Connector {
 public:
  Connector(const Framework& framework, const UnitSet& set)
      : framework_(framework),
        unit_count_(static_cast<std::uint32_t>(set.size())),
        members_(set, framework.joint_count()) {}

  UnitGraph run() {
    for (Bar bar : framework_.bars()) add_hinge(bar);
    std::sort(hinges_at_.begin(), hinges_at_.end());
    auto from = hinges_at_.begin();
    for (std::size_t i = 0; i < framework_.joint_count(); ++i) {
      const auto joint = static_cast<Joint>(i);
      auto to = from;
      while (to != hinges_at_.end() && to->first == joint) ++to;
      if (members_.at(joint).size() > 1) add_ball(joint, {from, to});
      from = to;
    }
    Graph links(unit_count_ + connections_.size(), edges_);
    Blocks blocks = find_blocks(links);
    return {unit_count_, std::move(connections_), std::move(links), std::move(blocks)};
  }

 private:
  using HingeAt = std::pair<Joint, std::uint32_t>;  ///< joint, connection

  void add_hinge(Bar bar) {
    members_.common(bar.a, bar.b, both_);
    if (both_.size() < 2) return;
    const auto index = static_cast<std::uint32_t>(connections_.size());
    connections_.push_back({std::min(bar.a, bar.b), std::max(bar.a, bar.b)});
    hinges_at_.emplace_back(bar.a, index);
    hinges_at_.emplace_back(bar.b, index);
    link(both_);
  }

  /// Links the units at a joint that no hinges at it link already.
  void add_ball(Joint joint, std::span<const HingeAt> hinges) {
    const auto units = members_.at(joint);
    const auto place = [&](std::uint32_t unit) {
      return static_cast<std::uint32_t>(std::lower_bound(units.begin(), units.end(), unit) -
                                        units.begin());
    };
    groups_.reset(units.size());
    for (const HingeAt& hinge : hinges) {
      const UnitConnection& connection = connections_[hinge.second];
      members_.common(connection.a, connection.b, both_);
      for (std::uint32_t unit : both_) groups_.unite(place(both_[0]), place(unit));
    }
    both_.clear();
    for (std::uint32_t k = 0; k < units.size(); ++k)
      if (groups_.find(k) == k) both_.push_back(units[k]);
    if (both_.size() < 2) return;
    connections_.push_back({joint, joint});
    link(both_);
  }

  void link(std::span<const std::uint32_t> units) {
    const auto node = static_cast<UnitNode>(unit_count_ + connections_.size() - 1);
    for (std::uint32_t unit : units) edges_.push_back({unit, node});
  }

  const Framework& framework_;
  std::uint32_t unit_count_;
  UnitsOfJoints members_;
  std::vector<UnitConnection> connections_;
  std::vector<Graph::Edge> edges_;
  std::vector<HingeAt> hinges_at_;
  DisjointSets groups_;
  std::vector<std::uint32_t> both_;
};

/// The units of each set as one.
MergedUnits united(const UnitSet& set, DisjointSets& groups) {
  MergedUnits merged;
  std::vector<std::vector<Joint>> joints;
  merged.of_unit.assign(set.size(), 0);
  for (std::uint32_t unit = 0; unit < set.size(); ++unit) {
    const std::uint32_t first = groups.find(unit);
    if (first == unit) {
      merged.of_unit[unit] = static_cast<std::uint32_t>(joints.size());
      joints.emplace_back();
    }
    const std::uint32_t now = merged.of_unit[unit] = merged.of_unit[first];
    joints[now].insert(joints[now].end(), set.at(unit).begin(), set.at(unit).end());
  }
  for (auto& members : joints) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    merged.set.add(members);
  }
  return merged;
}

/// Looks for loops that are rigid, and unites their units.
class LoopMerger {
 public:
  LoopMerger(const UnitSet& set, const UnitGraph& graph)
      : set_(set), graph_(graph), reach_(graph.links.node_count()) {
    groups.reset(set.size());
  }

  DisjointSets groups;

  bool unite_short_loops() {
    bool any = false;
    for (std::uint32_t unit = 0; unit < set_.size(); ++unit)
      if (is_in_loop(unit)) any = unite_loops_at(unit) || any;
    return any;
  }

  bool unite_rigid_blocks() {
    count_blocks();
    return unite_blocks([&](std::uint32_t block) { return freedom_[block] <= 0; });
  }

  bool unite_all_blocks() {
    return unite_blocks([](std::uint32_t) { return true; });
  }

 private:
  /// How a node was reached from the unit in hand.
  struct Reach {
    std::uint32_t search = 0;
    int cost = 0;
    UnitNode branch = 0;  ///< the first connection on the way
    UnitNode from = 0;
  };
  static constexpr int most_freedom = 6;
  /// A unit of a molecule reaches some dozens; of a network of bars with hubs, everything.
  static constexpr std::size_t most_nodes = 4096;

  bool is_in_loop(UnitNode node) const {
    for (const Link& at : graph_.links.at(node))
      if (!graph_.blocks.is_bridge[at.edge]) return true;
    return false;
  }

  /// A rod that turns about itself does not count: one way to move less.
  int weight(UnitNode node) const {
    if (!graph_.is_unit(node)) return graph_.connection(node).freedom();
    return set_.at(node).size() == 2 ? -1 : 0;
  }

  /// Goes outward from a unit; where two branches meet at the price of six or less is a rigid loop.
  bool unite_loops_at(UnitNode unit) {
    ++search_;
    waiting_.assign(1, unit);
    reach_[unit] = {search_, 0, unit, unit};
    bool any = false;
    for (std::size_t next = 0; next < waiting_.size() && next < most_nodes; ++next) {
      const UnitNode here = waiting_[next];
      for (const Link& at : graph_.links.at(here))
        if (!graph_.blocks.is_bridge[at.edge]) any = step(unit, here, at.node) || any;
    }
    return any;
  }

  bool step(UnitNode root, UnitNode here, UnitNode there) {
    if (there == reach_[here].from) return false;
    const Reach way{search_, reach_[here].cost + weight(there),
                    here == root ? there : reach_[here].branch, here};
    if (way.cost > most_freedom) return false;
    if (reach_[there].search != search_) {
      reach_[there] = way;
      waiting_.push_back(there);
      return false;
    }
    const Reach& known = reach_[there];
    if (there == root || known.branch == way.branch) return false;
    if (reach_[here].cost + known.cost + weight(root) > most_freedom) return false;
    const bool from_here = unite_way(root, here), from_there = unite_way(root, there);
    return from_here || from_there;
  }

  bool unite_way(UnitNode root, UnitNode node) {
    bool any = false;
    for (; node != root; node = reach_[node].from)
      if (graph_.is_unit(node)) any = groups.unite(root, node) || any;
    return any;
  }

  /// Freedom of each block: of its connections, less six for each independent loop.
  void count_blocks() {
    const std::size_t count = graph_.blocks.count;
    std::vector<std::int64_t> links(count, 0), nodes(count, 0);
    freedom_.assign(count, 0);
    for (UnitNode node = 0; node < graph_.links.node_count(); ++node)
      for_blocks_of(node, [&](std::uint32_t block, std::int64_t degree) {
        links[block] += degree;
        ++nodes[block];
        freedom_[block] += graph_.is_unit(node) ? weight(node) : weight(node) * (degree - 1);
      });
    for (std::size_t k = 0; k < count; ++k) freedom_[k] -= 6 * (links[k] / 2 - nodes[k] + 1);
  }

  /// Calls `each(block, links of the node in it)`.
  template <class Each>
  void for_blocks_of(UnitNode node, Each each) {
    at_node_.clear();
    for (const Link& at : graph_.links.at(node)) at_node_.push_back(graph_.blocks.of_edge[at.edge]);
    std::sort(at_node_.begin(), at_node_.end());
    for (std::size_t k = 0, next = 0; k < at_node_.size(); k = next) {
      while (next < at_node_.size() && at_node_[next] == at_node_[k]) ++next;
      each(at_node_[k], static_cast<std::int64_t>(next - k));
    }
  }

  template <class Which>
  bool unite_blocks(Which which) {
    std::vector<std::uint32_t> first(graph_.blocks.count, none);
    bool any = false;
    for (std::uint32_t unit = 0; unit < set_.size(); ++unit)
      for (const Link& at : graph_.links.at(unit)) {
        const std::uint32_t block = graph_.blocks.of_edge[at.edge];
        if (graph_.blocks.is_bridge[at.edge] || !which(block)) continue;
        if (first[block] == none) first[block] = unit;
        any = groups.unite(first[block], unit) || any;
      }
    return any;
  }

  static constexpr auto none = static_cast<std::uint32_t>(-1);
  const UnitSet& set_;
  const UnitGraph& graph_;
  std::vector<Reach> reach_;
  std::uint32_t search_ = 0;
  std::vector<UnitNode> waiting_;
  std::vector<std::uint32_t> at_node_;
  std::vector<std::int64_t> freedom_;
};

/// Units united by `unite(merger)` until it finds nothing more.
template <class Unite>
MergedUnits merge_while(const Framework& framework, UnitSet set, Unite unite) {
  MergedUnits all{std::move(set), {}};
  all.of_unit.resize(all.set.size());
  std::iota(all.of_unit.begin(), all.of_unit.end(), 0u);
  for (;;) {
    const UnitGraph graph = connect_units(framework, all.set);
    if (!graph.has_loops()) return all;
    LoopMerger merger(all.set, graph);
    if (!unite(merger)) return all;
    MergedUnits now = united(all.set, merger.groups);
    for (std::uint32_t& unit : all.of_unit) unit = now.of_unit[unit];
    all.set = std::move(now.set);
  }
}

}  // namespace

UnitGraph connect_units(const Framework& framework, const UnitSet& set) {
  return Connector(framework, set).run();
}

MergedUnits merge_rigid_loops(const Framework& framework, UnitSet set) {
  return merge_while(framework, std::move(set), [](LoopMerger& merger) {
    return merger.unite_short_loops() || merger.unite_rigid_blocks();
  });
}

MergedUnits merge_all_loops(const Framework& framework, UnitSet set) {
  return merge_while(framework, std::move(set),
                     [](LoopMerger& merger) { return merger.unite_all_blocks(); });
}

}  // namespace pliant
