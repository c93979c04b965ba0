// SPDX-License-Identifier: MIT
#include "pliant/base/graphs/graph.hpp"

#include "pliant/base/graphs/graph_search.hpp"

namespace pliant {

template Components find_components(const Graph& graph);
template Blocks find_blocks(const Graph& graph);

}  // namespace pliant
