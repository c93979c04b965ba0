// SPDX-License-Identifier: MIT
#include "pliant/framework/graph.hpp"

#include "pliant/base/graphs/graph_search.hpp"

namespace pliant {
Components find_components(const Framework& framework) {
  return find_components(framework.graph());
}

Blocks find_blocks(const Framework& framework) { return find_blocks(framework.graph()); }

GraphFacts graph_facts(const Framework& framework) {
  const Blocks blocks = find_blocks(framework);
  GraphFacts facts;
  facts.joints = framework.joint_count();
  facts.bars = framework.bar_count();
  facts.components = find_components(framework).count;
  facts.cycles = facts.bars + facts.components - facts.joints;
  facts.bridges = blocks.bridge_count;
  facts.blocks = blocks.count - blocks.bridge_count;
  facts.bars_in_blocks = facts.bars - facts.bridges;
  facts.largest_block = facts.blocks > 0 ? blocks.largest : 0;
  return facts;
}

}  // namespace pliant
