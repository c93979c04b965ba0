// SPDX-License-Identifier: MIT
#include "pliant/base/graph.hpp"

#include "pliant/base/graph_search.hpp"

namespace pliant {

template Components find_components(const Graph& graph);
template Blocks find_blocks(const Graph& graph);

}  // namespace pliant
