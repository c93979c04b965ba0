// SPDX-License-Identifier: MIT
// Crystal B factors as an elastic network has them: which residues a crystal would show to be
// flexible, beside which others.
#pragma once

#include <vector>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

/// (M) B factors relative to their mean: the diagonal of the pseudoinverse of Kirchhoff's matrix of
/// the springs of network `shared`, uncut, alike in all directions (Gaussian network model: Bahar,
/// Atilgan, Erman, Fold. Des. 2 (1997) 173); springs below 1e-6 are left out. No unit: how large B
/// factors are depends on the crystal. Above 3000 nodes those that coarsened() merges share a
/// value. Takes the cube of the number of nodes. Nodes pass check(); there may be joints without a
/// node.
std::vector<double> relative_b_factors(const NetworkNodes& nodes);

}  // namespace pliant
