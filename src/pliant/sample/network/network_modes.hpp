// SPDX-License-Identifier: MIT
// Modes of an elastic network (normal modes, principal components of its Gaussian): directions in
// which the nodes move together, and how far.
#pragma once

#include <string_view>
#include <vector>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

struct NetworkModes {
  std::vector<double> variances;  ///< (K) descending; Angstrom^2 once scaled
  DenseMatrix directions;         ///< (K x 3M) rows of unit length: x, y, z of each node
};

inline constexpr std::size_t usual_mode_count = 60;

/// The `count` modes of largest variance of a network of the table, or as many as there are; in the
/// unit of 1 / its springs. With domains: of the mean covariance of the network and of the same cut
/// into 2, 3 and 4 domains, where springs between domains are a tenth; the covariance of each is
/// that of its `count` lowest modes, divided by its trace. Signs are canonical.
/// Takes the cube of the number of nodes: coarsened() first. They pass check(). Throws OptionError
/// on an unknown name.
NetworkModes network_modes(const NetworkNodes& nodes, std::string_view network = "shared",
                           std::size_t count = usual_mode_count);

/// Scales variances so that the r.m.s. fluctuation of nodes, meant over nodes, is `amplitude`
/// (Angstrom).
void scale_to(double amplitude, NetworkModes& modes);

/// (M) r.m.s. fluctuation of each node (Angstrom).
std::vector<double> fluctuations(const NetworkModes& modes);

}  // namespace pliant
