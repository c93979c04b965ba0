// SPDX-License-Identifier: MIT
// Facts of the graph under a framework: connected components, independent cycles, bridges and
// blocks (biconnected components). All linear in joints + bars, none recursive.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Which component each joint is in; components are numbered by their lowest joint.
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_joint;  ///< (N)
  std::vector<Joint> lowest_joint;      ///< (count)
};

Components find_components(const Framework& framework);

/// Which block each bar is in. A bridge (a bar on no cycle) is a block of one bar.
struct Blocks {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_bar;  ///< (B)
  std::vector<bool> is_bridge;        ///< (B)
  std::size_t bridge_count = 0;
  std::size_t largest = 0;  ///< bars in the largest block
};

/// Blocks by lowpoints (Hopcroft, Tarjan, CACM 16 (1973) 372).
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
