// SPDX-License-Identifier: MIT
// What a trajectory says of its molecule.
#pragma once

#include <vector>

#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant::app {

std::vector<RecordedBond> recorded_bonds(const Structure& structure);

/// Bonds, masses (not of a graph, whose joints are no atoms) and the version; parameters are left
/// empty.
H5mdHeader molecule_header(const Structure& structure);

}  // namespace pliant::app
