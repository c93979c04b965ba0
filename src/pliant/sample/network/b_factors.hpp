// SPDX-License-Identifier: MIT
// B factors of an elastic network: which residues should be flexible relative to others in a
// crystal.
#pragma once

#include <vector>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

/// (M) B factors relative to their mean: the diagonal of the pseudoinverse of the Kirchhoff matrix
/// of the springs of network `shared`, uncut and isotropic (Gaussian network model: Bahar, Atilgan,
/// Erman, Fold. Des. 2 (1997) 173); springs below 1e-6 are left out. Dimensionless: absolute B
/// factors depend on the crystal. Above 3000 nodes those that coarsened() merges share a value.
/// Takes the cube of the number of nodes. Nodes must pass check(); joints may have no node.
std::vector<double> relative_b_factors(const NetworkNodes& nodes);

}  // namespace pliant
