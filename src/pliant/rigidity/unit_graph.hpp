// SPDX-License-Identifier: MIT
// The graph of rigid units (body-bar-hinge framework): connections, the loops they close, and which
// loops are rigid, so that their units merge.
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
  /// Degrees of freedom of one unit against another.
  int freedom() const { return is_hinge() ? 1 : 3; }
};

using UnitNode = std::uint32_t;  ///< node of UnitGraph::links

/// Units and connections as the two kinds of nodes of one graph. Units that share a joint and are
/// connected there by hinges already get no further connection, so that without loops the graph is
/// a forest.
struct UnitGraph {
  std::size_t units = 0;
  std::vector<UnitConnection> connections;
  Graph links;    ///< node u < units is a unit, node units + c a connection
  Blocks blocks;  ///< of links; a block that is not a bridge holds one loop or more

  bool is_unit(UnitNode node) const { return node < units; }
  const UnitConnection& connection(UnitNode node) const { return connections[node - units]; }
  bool has_loops() const { return blocks.bridge_count < links.edge_count(); }
};

UnitGraph connect_units(const Framework& framework, const UnitSet& set);

/// Units after some loops were merged.
struct MergedUnits {
  UnitSet set;
  std::vector<std::uint32_t> of_unit;  ///< the new unit of each old unit
};

/// Merges rigid loops until none is left: loops of hinges with at most six degrees of freedom (n
/// hinges leave n - 6, so these are rings of up to six atoms and what is fused to them), then whole
/// blocks with as many equations as freedoms.
MergedUnits merge_rigid_loops(const Framework& framework, UnitSet set);

/// Merges all remaining loops: each becomes one unit that can change its shape.
MergedUnits merge_all_loops(const Framework& framework, UnitSet set);

}  // namespace pliant
