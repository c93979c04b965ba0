// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/largest_molecule.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant {

Structure largest_molecule(const Structure& structure, const Log& log) {
  if (!is_from(structure, &Format::has_small_molecules)) return structure;
  const Components parts = find_components(Graph(structure.size(), structure.bonds));
  if (parts.count < 2) return structure;
  std::vector<std::pair<std::size_t, std::size_t>> sizes(parts.count);  // heavy atoms, atoms
  for (std::size_t k = 0; k < structure.size(); ++k) {
    auto& [heavy, all] = sizes[parts.of_node[k]];
    heavy += structure.atoms.elements[k] == 1 ? 0 : 1;
    ++all;
  }
  const auto kept = static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
  std::vector<bool> is_out(structure.size());
  for (std::size_t k = 0; k < structure.size(); ++k) is_out[k] = parts.of_node[k] != kept;
  log.note("the largest of " + std::to_string(parts.count) +
           " molecules is kept: " + std::to_string(sizes[kept].second) + " of " +
           std::to_string(structure.size()) + " atoms");
  return without_atoms(structure, is_out).structure;
}

}  // namespace pliant
