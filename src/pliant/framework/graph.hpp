// SPDX-License-Identifier: MIT
// Properties of the graph of a framework: connected components, independent cycles, bridges and
// blocks (biconnected components).
#pragma once

#include "pliant/base/graphs/graph.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Nodes are joints, edges are bars.
Components find_components(const Framework& framework);
Blocks find_blocks(const Framework& framework);

/// The figures that `pliant info` prints.
struct GraphFacts {
  std::size_t joints = 0, bars = 0;
  std::size_t components = 0;
  std::size_t cycles = 0;  ///< independent cycles: bars - joints + components
  std::size_t bridges = 0;
  std::size_t blocks = 0;          ///< blocks of two or more bars: rings and ring systems
  std::size_t largest_block = 0;   ///< bars in the largest such block
  std::size_t bars_in_blocks = 0;  ///< bars on some cycle
  bool is_forest() const { return cycles == 0; }
};

GraphFacts graph_facts(const Framework& framework);

}  // namespace pliant
