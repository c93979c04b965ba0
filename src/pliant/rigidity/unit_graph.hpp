// SPDX-License-Identifier: MIT
// How rigid units hang together (body-bar-hinge framework): connections, the loops they close, and
// which loops leave no freedom, so that their units are one.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/rigidity/unit_set.hpp"

namespace pliant {

/// What two or more units share: a hinge (two joints and the bar between them), or one joint.
struct UnitConnection {
  Joint a = 0, b = 0;
  bool is_hinge() const { return a != b; }
  /// Ways in which one unit moves against another.
  int freedom() const { return is_hinge() ? 1 : 3; }
};

using UnitNode = std::uint32_t;  ///< of UnitGraph::links

/// Units and connections as the two kinds of nodes of one graph. Units that share a joint and hang
/// together by hinges at it need no connection more: without loops the graph is a forest.
struct UnitGraph {
  std::size_t units = 0;
  std::vector<UnitConnection> connections;
  Graph links;    ///< node u < units is a unit, node units + c a connection
  Blocks blocks;  ///< of links; a block that is no bridge is a loop or several

  bool is_unit(UnitNode node) const { return node < units; }
  const UnitConnection& connection(UnitNode node) const { return connections[node - units]; }
  bool has_loops() const { return blocks.bridge_count < links.edge_count(); }
};

UnitGraph connect_units(const Framework& framework, const UnitSet& set);

/// Units of which some are loops of the units before.
struct MergedUnits {
  UnitSet set;
  std::vector<std::uint32_t> of_unit;  ///< the new unit of each old one
};

/// Unites what loops make rigid, again and again: loops of hinges with at most six ways to move (n
/// hinges leave n - 6: rings of up to six atoms, and what is fused of them), then whole blocks that
/// have as many equations as freedoms.
MergedUnits merge_rigid_loops(const Framework& framework, UnitSet set);

/// Unites what is left of loops: each becomes one unit that changes its shape.
MergedUnits merge_all_loops(const Framework& framework, UnitSet set);

}  // namespace pliant
