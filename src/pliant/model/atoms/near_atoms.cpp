// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/near_atoms.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/base/math/cell_list.hpp"

namespace pliant {

Grouped<std::uint32_t> near_atoms(const Structure& structure,
                                  std::span<const std::uint32_t> centres,
                                  std::span<const std::uint32_t> others, double reach) {
  std::vector<Vec3> points;
  for (std::uint32_t atom : centres) points.push_back(structure.positions[atom]);
  for (std::uint32_t atom : others) points.push_back(structure.positions[atom]);
  const auto first_other = static_cast<std::uint32_t>(centres.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // centre, atom
  CellList(points, reach).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    if (i >= first_other || j < first_other) return;
    const std::uint32_t other = others[j - first_other];
    if (other != centres[i]) pairs.emplace_back(i, other);
  });
  std::sort(pairs.begin(), pairs.end());
  return Grouped<std::uint32_t>(centres.size(), [&](const auto& put) {
    for (const auto& [centre, atom] : pairs) put(centre, atom);
  });
}

}  // namespace pliant
