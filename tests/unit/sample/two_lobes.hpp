// SPDX-License-Identifier: MIT
// A network of two compact lobes of one chain, joined by a strand.
#pragma once

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant::test {

inline constexpr std::size_t lobe_nodes = 27, strand_nodes = 4;

/// A chain that fills two cubes of 3 x 3 x 3 nodes, 3.8 Angstrom apart, with a strand along x
/// between them.
inline NetworkNodes two_lobes() {
  constexpr double step = 3.8;
  NetworkNodes nodes;
  // Snakes, so that neighbours along the chain are neighbours in space.
  const auto add_cube = [&](double x0, bool from_far_corner) {
    for (int x = 0; x < 3; ++x)
      for (int k = 0; k < 3; ++k)
        for (int m = 0; m < 3; ++m) {
          const int y = x % 2 == 0 ? k : 2 - k;
          const int z = (3 * x + k) % 2 == 0 ? m : 2 - m;
          nodes.positions.push_back({x0 + step * x, step * (from_far_corner ? 2 - y : y),
                                     step * (from_far_corner ? 2 - z : z)});
        }
  };
  add_cube(0.0, false);
  const Vec3 end = nodes.positions.back();
  for (std::size_t k = 1; k <= strand_nodes; ++k)
    nodes.positions.push_back({end.x + step * double(k), end.y, end.z});
  add_cube(end.x + step * double(strand_nodes + 1), true);
  nodes.chain.assign(nodes.positions.size(), 0);
  nodes.of_joint.resize(nodes.positions.size());
  for (std::uint32_t k = 0; k < nodes.of_joint.size(); ++k) nodes.of_joint[k] = k;
  return nodes;
}

}  // namespace pliant::test
