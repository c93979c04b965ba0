// SPDX-License-Identifier: MIT
#include "pliant/sample/network/softness.hpp"

#include <vector>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/network/lowest_modes.hpp"

namespace pliant {
namespace {

constexpr double cutoff = 10.0;  // Angstrom

DenseMatrix springs_of(std::span<const Vec3> nodes, double scale) {
  std::vector<std::vector<std::uint32_t>> near(nodes.size());
  CellList(nodes, cutoff * scale).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    near[i].push_back(j);
    near[j].push_back(i);
  });
  DenseMatrix shared(nodes.size(), nodes.size());
  for (const auto& around : near)
    for (const std::uint32_t i : around)
      for (const std::uint32_t j : around) shared(i, j) += 1.0;
  DenseMatrix springs(nodes.size(), nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    for (const std::uint32_t j : near[i]) springs(i, j) = shared(i, j);
  return springs;
}

}  // namespace

double softness(std::span<const Vec3> nodes, double scale) {
  const EigenPairs lowest = lowest_modes(stiffness(nodes, springs_of(nodes, scale), false),
                                         rigid_motions(nodes, false), 1);
  return lowest.values.empty() ? 0.0 : 1.0 / lowest.values.front();
}

}  // namespace pliant
