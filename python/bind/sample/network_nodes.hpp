// SPDX-License-Identifier: MIT
// The nodes of a structure for elastic networks.
#pragma once

#include <utility>

#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/sample/network/elastic_network.hpp"

namespace pliant::python {

inline NetworkNodes nodes_of(const Structure& structure) {
  ResidueNodes found = residue_nodes(structure);
  return {std::move(found.positions), std::move(found.chain), std::move(found.of_atom)};
}

}  // namespace pliant::python
