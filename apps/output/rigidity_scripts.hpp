// SPDX-License-Identifier: MIT
// Scripts with which PyMOL and ChimeraX colour a molecule by its rigid clusters.
#pragma once

#include <cstddef>
#include <string>

namespace pliant::app {

/// Both load clusters.pdb, whose B factors are numbers of clusters, and flexibility.pdb, where they
/// are 100 times the flexibility index. The first `clusters` have colours
/// of their own (cluster_colour); others are grey.
/// Colours of flexibility go from 0 to `most`, of that B factor.
std::string rigidity_pymol_script(std::size_t clusters, bool is_polymer, double most);
std::string rigidity_chimerax_script(std::size_t clusters, bool is_polymer, double most);

}  // namespace pliant::app
