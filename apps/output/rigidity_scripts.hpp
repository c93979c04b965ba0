// SPDX-License-Identifier: MIT
// Scripts for PyMOL and ChimeraX that colour a molecule by its rigid clusters.
#pragma once

#include <cstddef>
#include <string>

namespace pliant::app {

/// Both load clusters.pdb, whose B factors are numbers of clusters, and flexibility.pdb, whose B
/// factors are 100 times the flexibility index. The first `clusters` get different colours
/// (cluster_colour), others grey. Colours of flexibility range from 0 to `most`, a B factor.
std::string rigidity_pymol_script(std::size_t clusters, bool is_polymer, double most);
std::string rigidity_chimerax_script(std::size_t clusters, bool is_polymer, double most);

}  // namespace pliant::app
