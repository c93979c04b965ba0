// SPDX-License-Identifier: MIT
// Modes of an elastic network (normal modes, principal components of its Gaussian): collective
// directions of the nodes, and their variances.
#pragma once

#include <span>
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

/// The `count` modes of largest variance of a network of the table, or all if there are fewer;
/// variances are in units of 1 / spring. With domains, these are the modes of the mean covariance
/// of the network and of the same network cut into 2, 3 and 4 domains, where springs between
/// domains are a tenth; each covariance is that of the `count` lowest modes, divided by its trace.
/// Signs are canonical. Takes the cube of the number of nodes: call coarsened() first. Threads
/// change no bit. Nodes must pass check(). Throws OptionError for an unknown name.
NetworkModes network_modes(const NetworkNodes& nodes, std::string_view network = "shared",
                           std::size_t count = usual_mode_count, std::size_t threads = 1);

/// Scales variances so that the mean over nodes of the r.m.s. fluctuation is `amplitude`
/// (Angstrom).
void scale_to(double amplitude, NetworkModes& modes);

/// (M) r.m.s. fluctuation of each node (Angstrom).
std::vector<double> fluctuations(const NetworkModes& modes);

/// (M) How far nodes move along modes by `amplitudes` (K), in standard deviations (Angstrom).
std::vector<Vec3> moves_along(const NetworkModes& modes, std::span<const double> amplitudes);

}  // namespace pliant
